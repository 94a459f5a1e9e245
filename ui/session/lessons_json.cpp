#include "ui/session/lessons_json.h"

#include <QJsonArray>
#include <cmath>

#include "ui/session/session_json.h"

namespace feedscope::ui {
namespace {

constexpr int most_questions = 10000;

QJsonArray to_json(const std::vector<LessonTry>& tries) {
  QJsonArray json;
  for (const LessonTry& one : tries) {
    QJsonObject row{{"value", QString::fromStdString(one.value)}, {"cycle_time_s", one.cycle_time}};
    if (one.measured) {
      row["measured"] = *one.measured;
    }
    json.append(row);
  }
  return json;
}

LessonTry read_try(const QJsonObject& json, const QString& place, QStringList& notes) {
  note_unknown(json, {"value", "cycle_time_s", "measured"}, place, notes);
  LessonTry one{json["value"].toString().toStdString(), json["cycle_time_s"].toDouble(-1), std::nullopt};
  if (!(one.cycle_time >= 0)) {
    throw input_error(QStringLiteral("%1: \"cycle_time_s\" must be a number from 0").arg(place));
  }
  if (json["measured"].isDouble()) {
    one.measured = json["measured"].toDouble();
  }
  return one;
}

}  // namespace

void put_lessons(const LessonWork& work, QJsonObject& session) {
  QJsonArray json;
  QJsonObject predictions;
  QJsonObject transfers;
  for (const auto& [where, done] : work) {
    if (where.second == prediction || where.second == transfer) {
      if (!done.answer.isEmpty()) {
        (where.second == prediction ? predictions : transfers)[QString::fromStdString(where.first)] =
            done.answer;
      }
      continue;
    }
    if (done.answer.isEmpty() && done.tries.empty()) {
      continue;
    }
    QJsonObject question{{"lesson", QString::fromStdString(where.first)},
                         {"question", static_cast<int>(where.second) + 1}};
    if (!done.answer.isEmpty()) {
      question["answer"] = done.answer;
    }
    if (!done.tries.empty()) {
      question["setting"] = QString::fromStdString(done.setting);
      question["measure"] = QString::fromStdString(done.measure);
      question["tries"] = to_json(done.tries);
    }
    json.append(question);
  }
  session["lessons"] = json;
  if (!predictions.isEmpty()) {
    session["predictions"] = predictions;
  }
  if (!transfers.isEmpty()) {
    session["transfers"] = transfers;
  }
}

LessonWork read_lessons(const QJsonObject& session, QStringList& notes) {
  LessonWork work;
  for (const auto& [key, where] : {std::pair("predictions", prediction), std::pair("transfers", transfer)}) {
    const QJsonObject texts = session[QLatin1String(key)].toObject();
    for (const QString& lesson : texts.keys()) {
      work[{lesson.toStdString(), where}].answer = texts[lesson].toString();
    }
  }
  int number = 0;
  for (const QJsonValue& value : session["lessons"].toArray()) {
    const QJsonObject question = value.toObject();
    const QString place = QStringLiteral("lessons, entry %1").arg(++number);
    note_unknown(question, {"lesson", "question", "answer", "setting", "measure", "tries"}, place, notes);
    const std::string lesson = question["lesson"].toString().toStdString();
    if (lesson.empty()) {
      throw input_error(QStringLiteral("%1: \"lesson\" must be the id of a lesson").arg(place));
    }
    const double at = question["question"].toDouble();
    if (!(at >= 1 && at <= most_questions && at == std::floor(at))) {
      throw input_error(QStringLiteral("%1: \"question\" must be a whole number from 1").arg(place));
    }
    QuestionWork& done = work[{lesson, static_cast<std::size_t>(at) - 1}];
    done.answer = question["answer"].toString();
    done.setting = question["setting"].toString().toStdString();
    done.measure = question["measure"].toString().toStdString();
    done.tries.clear();
    for (const QJsonValue& row : question["tries"].toArray()) {
      done.tries.push_back(read_try(row.toObject(), place, notes));
    }
  }
  return work;
}

}  // namespace feedscope::ui
