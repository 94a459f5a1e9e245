#include "app/commands/language_option.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "ui/language/language.h"
#include "ui/report/session_input.h"
#include "ui/scene_view/scene_texts.h"

namespace feedscope {

std::string usual_language() {
  return ui::languages().front().toStdString();
}

void add_language_option(CLI::App& command, std::string& language) {
  language = usual_language();
  std::vector<std::string> codes;
  for (const QString& code : ui::languages()) {
    codes.push_back(code.toStdString());
  }
  command
      .add_option(
          "--language", language,
          fmt::format("Language of texts, numbers and dates: {} [{}]", fmt::join(codes, " or "), language))
      ->check(CLI::IsMember(codes))
      ->type_name("LANGUAGE");
}

void speak_in(const std::string& language, ui::ReportInput& input,
              const std::optional<ui::Session>& session) {
  if (language == usual_language()) {
    return;
  }
  ui::speak(QString::fromStdString(language));
  input.texts = ui::scene_texts();
  std::vector<std::shared_ptr<const ui::ShownRun>> shown;
  for (const ui::ReportRun& run : input.runs) {
    shown.push_back(run.shown);
  }
  const std::vector<ui::ReportRun> named =
      session ? ui::report_input(*session, shown).runs : ui::report_runs(shown);
  for (std::size_t i = 0; i < named.size(); ++i) {
    input.runs[i].name = named[i].name;
  }
}

}  // namespace feedscope
