#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QJsonArray>
#include <QJsonDocument>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <fstream>
#include <random>

#include "tests/support/random_cases.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "tests/ui/session/some_session.h"
#include "ui/runs/run_notice.h"
#include "ui/session/session_file.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {
namespace {

const unsigned mutations = test::random_cases(120U);

enum class Wrong { truncated, bytes, type, removed, junk, number, duplicates, word };
constexpr std::array wrongs{"truncated text", "other bytes", "another type",     "removed",
                            "nested junk",    "huge number", "duplicated items", "wrong word"};  // as Wrong

/// One wrong thing at a random place of a session file.
class Mutation {
 public:
  explicit Mutation(unsigned seed) : random_(seed), wrong_(static_cast<Wrong>(seed % wrongs.size())) {}

  const char* name() const { return wrongs.at(static_cast<std::size_t>(wrong_)); }
  QByteArray of(QByteArray session) {
    if (wrong_ == Wrong::truncated) {
      return session.left(any(session.size()));
    }
    if (wrong_ == Wrong::bytes) {
      for (int i = 0; i < 5; ++i) {
        session[any(session.size())] = static_cast<char>(any(256));
      }
      return session;
    }
    const QJsonObject json = QJsonDocument::fromJson(session).object();
    to_go_ = 1 + any(count_in(json));
    return QJsonDocument(changed(json).toObject()).toJson();
  }

 private:
  int any(qsizetype count) { return static_cast<int>(random_() % static_cast<unsigned long>(count)); }
  QJsonValue one_of(const QJsonArray& values) { return values[any(values.size())]; }

  bool fits(const QJsonValue& value) const {
    switch (wrong_) {
      case Wrong::number:
        return value.isDouble();
      case Wrong::duplicates:
        return value.isArray();
      case Wrong::word:
        return value.isString();
      default:
        return true;
    }
  }

  int count_in(const QJsonValue& value) const {
    int count = fits(value) ? 1 : 0;
    for (const QJsonValue& item : value.toArray()) {
      count += count_in(item);
    }
    for (const QJsonValue& item : value.toObject()) {
      count += count_in(item);
    }
    return count;
  }

  QJsonValue changed(const QJsonValue& value) {
    if (fits(value) && --to_go_ == 0) {
      return other_than(value);
    }
    if (value.isArray()) {
      QJsonArray items;
      for (const QJsonValue& item : value.toArray()) {
        items.append(changed(item));
      }
      return items;
    }
    QJsonObject object = value.toObject();
    for (const QString& key : object.keys()) {
      object[key] = changed(object[key]);
    }
    return value.isObject() ? QJsonValue(object) : value;
  }

  QJsonValue other_than(const QJsonValue& value) {
    switch (wrong_) {
      case Wrong::removed:
        return QJsonValue::Undefined;
      case Wrong::junk:
        return nested(value);
      case Wrong::number:
        return one_of({1e308, -1e308, 1e-308, 1e15, 4294967296.0, 2147483648.0, -1, 0, 0.5});
      case Wrong::duplicates:
        return duplicated(value.toArray());
      case Wrong::word:
        return one_of(
            {"", " ", "no such thing", "..", "/", QString(5000, 'x'), QString(QChar(0)), "é", "nan"});
      default:
        return one_of({QJsonValue(), true, 17, "17", QJsonArray{1, "two"}, QJsonObject{{"a", 1}}});
    }
  }

  QJsonValue nested(QJsonValue junk) {
    for (int depth = 1 + any(300); depth > 0; --depth) {
      if (any(2) == 0) {
        junk = QJsonArray{junk, true};
      } else {
        junk = QJsonObject{{"junk", junk}};
      }
    }
    return junk;
  }

  QJsonArray duplicated(const QJsonArray& items) {
    QJsonArray many;
    for (int times = 2 + any(4); times > 0; --times) {
      for (const QJsonValue& item : items) {
        many.append(item);
      }
    }
    return many;
  }

  std::mt19937 random_;
  Wrong wrong_;
  int to_go_ = 0;  ///< places that fit until the one that becomes wrong
};

class WindowMutationTest : public testing::Test {
 protected:
  WindowMutationTest() {
    std::ofstream(path("part.nc")) << test::small_program;
    window.resize(1000, 700);
    window.show();
    QObject::connect(&answering, &QTimer::timeout, [this] { answer(); });
    answering.start(1);
  }

  std::filesystem::path path(const std::string& name) const {
    return std::filesystem::path(folder.path().toStdString()) / name;
  }

  QByteArray session() const {
    Session session = some_session(path("part.nc"));
    session.program_hash = hash_of(session.program);
    session.reading.tool_table.clear();
    return session_bytes(session, path("part.nc").parent_path());
  }

  /// A program that is not there is not looked for; one that has changed is opened, and nothing is saved.
  void answer() const {
    QWidget* dialog = QApplication::activeModalWidget();
    if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
      for (const auto wanted : {QMessageBox::Discard, QMessageBox::Yes, QMessageBox::Ok}) {
        if (QAbstractButton* button = box->button(wanted)) {
          button->click();
          return;
        }
      }
    }
    if (dialog != nullptr) {
      dialog->close();
    }
  }

  /// What was said to be wrong; empty if the session is shown.
  QString open(const std::filesystem::path& file) {
    QSignalSpy failed(&window.session(), &WindowSession::failed);
    window.open(file);
    EXPECT_TRUE(QTest::qWaitFor([this] { return !model.busy() && !window.busy(); }, patience));
    QCoreApplication::processEvents();
    return failed.isEmpty() ? QString() : failed[0][0].toString();
  }

  const QTemporaryDir folder;
  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
  QTimer answering;
};

TEST_F(WindowMutationTest, AWrongSessionIsShownOrNamedAsWrong) {
  const QByteArray right = session();
  unsigned shown = 0;
  for (unsigned seed = 0; seed < mutations && !HasFailure(); ++seed) {
    Mutation mutation(seed);
    const QByteArray wrong = mutation.of(right);
    SCOPED_TRACE(std::string(mutation.name()) + ", seed " + std::to_string(seed) + "\n" +
                 wrong.toStdString());
    const std::filesystem::path file = path("wrong" + std::to_string(seed) + ".feedscope");
    std::ofstream(file, std::ios::binary) << wrong.toStdString();
    const QString said = open(file);
    EXPECT_TRUE(window.isVisible());
    if (said.isEmpty()) {
      ++shown;
      EXPECT_EQ(window.session().file(), file);
      EXPECT_TRUE(model.shown() != nullptr || !window.part<RunNotice>().text().isEmpty())
          << "neither a run nor a reason";
      const QJsonObject again = to_json(window.session().capture(), folder.path().toStdString());
      EXPECT_NO_THROW(read_session(again, folder.path().toStdString(), shipped_machines()))
          << "what is shown can be saved";
    } else {
      EXPECT_TRUE(said.contains(QString::fromStdString(file.filename().string()))) << said.toStdString();
    }
  }
  EXPECT_GT(shown, mutations / 4) << "some do no harm";
  EXPECT_LT(shown, mutations) << "some do";
}

}  // namespace
}  // namespace feedscope::ui
