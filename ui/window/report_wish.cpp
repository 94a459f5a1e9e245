#include "ui/window/report_wish.h"

#include <QCoreApplication>

#include "ui/units/unit_system.h"

namespace feedscope::ui {

namespace {

struct Parts {
  Q_DECLARE_TR_FUNCTIONS(ReportParts)
};

}  // namespace

std::vector<ReportPart> report_parts() {
  return {
      {Parts::tr("Summary"), {QStringLiteral("summary")}},
      {Parts::tr("Comparison of the runs"),
       {QStringLiteral("comparison_table"), QStringLiteral("differing_settings")}},
      {Parts::tr("3D view"), {QStringLiteral("view")}},
      {Parts::tr("Annotations"), {QStringLiteral("notes")}},
      {Parts::tr("Where does the time go?"), {QStringLiteral("time_use"), QStringLiteral("time_places")}},
      {Parts::tr("What would help (simulated)"), {QStringLiteral("time_changes")}},
      {Parts::tr("Time by limiting cause"),
       {QStringLiteral("causes_table"), QStringLiteral("comparison_bars")}},
      {Parts::tr("Axes against their limits"), {QStringLiteral("peaks_table")}},
      {Parts::tr("Charts"), {QStringLiteral("charts"), QStringLiteral("cause_view")}},
      {Parts::tr("Places that lose most, with close-ups"),
       {QStringLiteral("slow_places"), QStringLiteral("slow_place_views")}},
      {Parts::tr("Contour error, with close-ups"),
       {QStringLiteral("contour_histogram"), QStringLiteral("contour_places"),
        QStringLiteral("contour_place_views")}},
      {Parts::tr("Agreement with the control"), {QStringLiteral("traces")}},
      {Parts::tr("Identification"),
       {QStringLiteral("identification"), QStringLiteral("identification_charts")}},
      {Parts::tr("Circular test"), {QStringLiteral("circles"), QStringLiteral("circle_plots")}},
      {Parts::tr("Cutting load"), {QStringLiteral("load"), QStringLiteral("load_view")}},
      {Parts::tr("Program"), {QStringLiteral("program_facts")}},
      {Parts::tr("Messages of the reader"), {QStringLiteral("messages")}},
      {Parts::tr("Machine with sources"), {QStringLiteral("machines")}},
      {Parts::tr("Settings and control models"), {QStringLiteral("settings"), QStringLiteral("models")}},
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
  add("without", wish.without.join(','));
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
