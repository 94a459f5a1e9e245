#include "ui/window/dialogs/report_wish.h"

#include <QCoreApplication>
#include <algorithm>

#include "ui/units/unit_system.h"

namespace feedscope::ui {

namespace {

struct Parts {
  Q_DECLARE_TR_FUNCTIONS(ReportParts)
};

}  // namespace

std::vector<ReportPart> report_parts() {
  const auto section = [](const QString& title, const char* name, bool usual = false) {
    return ReportPart{title, {}, QString::fromLatin1(name), usual};
  };
  return {
      {Parts::tr("What would help (simulated)"), {QStringLiteral("time_changes")}},
      {Parts::tr("Annotations"), {QStringLiteral("notes")}},
      {Parts::tr("Places that lose most, with close-ups"), {QStringLiteral("cards")}},
      section(Parts::tr("Motion"), "motion", true),
      section(Parts::tr("Machine, settings, models, trust"), "trust", true),
      {Parts::tr("Agreement with the control"), {QStringLiteral("traces")}},
      {Parts::tr("Identification"),
       {QStringLiteral("identification"), QStringLiteral("identification_charts")}},
      {Parts::tr("Cutting load"), {QStringLiteral("load"), QStringLiteral("load_view")}},
      section(Parts::tr("Appendix: figures of the runs"), "figures"),
      section(Parts::tr("Appendix: where does the time go?"), "time"),
      section(Parts::tr("Appendix: time by limiting cause"), "causes"),
      section(Parts::tr("Appendix: settings that differ"), "differing"),
      section(Parts::tr("Appendix: axes against their limits"), "axes"),
      section(Parts::tr("Appendix: charts"), "charts"),
      section(Parts::tr("Appendix: table of slow places"), "places"),
      section(Parts::tr("Appendix: contour error"), "contour"),
      section(Parts::tr("Appendix: circular test"), "circles"),
      section(Parts::tr("Appendix: program"), "program"),
      section(Parts::tr("Appendix: machine with sources"), "machine"),
      section(Parts::tr("Appendix: all settings"), "settings"),
      section(Parts::tr("Appendix: control models"), "models"),
  };
}

QStringList report_arguments(const ReportWish& wish, const QString& session) {
  QStringList arguments{session};
  const auto add = [&](const char* name, const QString& value) {
    if (!value.isEmpty()) {
      arguments.append(QStringLiteral("--%1=%2").arg(QLatin1String(name), value));
    }
  };
  add("title", wish.title);
  add("author", wish.author);
  add("date", wish.date.isValid() ? wish.date.toString(Qt::ISODate) : QString());
  add("remarks", wish.remarks);
  add("logo", wish.logo);
  add("template", wish.page);
  add("language", wish.language);
  add("paper", wish.paper);
  add("without", wish.without.join(','));
  const QStringList usual = ReportInput().with;
  QStringList more = wish.with;
  if (std::ranges::all_of(usual, [&](const QString& name) { return wish.with.contains(name); })) {
    more.removeIf([&](const QString& name) { return usual.contains(name); });
  } else {
    arguments.append(QStringLiteral("--brief"));
  }
  add("with", more.join(','));
  add("display-units", unit_system() == UnitSystem::inch ? QStringLiteral("inch") : QString());
  return arguments;
}

Session with_runs(Session session, const std::vector<bool>& wanted) {
  std::vector<std::optional<std::size_t>> row_now(session.runs.size());
  std::vector<RunItem> runs;
  for (std::size_t i = 0; i < session.runs.size(); ++i) {
    if (i < wanted.size() && wanted[i]) {
      row_now[i] = runs.size();
      runs.push_back(session.runs[i]);
    }
  }
  const auto now = [&](std::optional<std::size_t> row) {
    return row && *row < row_now.size() ? row_now[*row] : std::nullopt;
  };
  session.current_run = now(session.current_run).value_or(0);
  session.scenes.other = now(session.scenes.other);
  session.scenes.reference = now(session.scenes.reference);
  session.identification.choice.run = now(session.identification.choice.run);
  session.runs = std::move(runs);
  return session;
}

}  // namespace feedscope::ui
