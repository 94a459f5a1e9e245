#include "ui/program_text/reading_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>

#include "core/base/units.h"
#include "ui/fields/number_text.h"
#include "ui/fields/whole_number_box.h"
#include "ui/language/shown_numbers.h"
#include "ui/shared/paths.h"
#include "ui/shared/table_items.h"

namespace feedscope::ui {

namespace {

constexpr int max_lines = 2'000'000'000;
constexpr int max_calls = 100'000;
constexpr int lines_a_step = 1'000'000;
constexpr int recognised = -1;
constexpr int unit_of_program = -1;
constexpr double largest_radius = 1e6;  // [mm]

enum CutterColumn { tool_column, radius_column, source_column, column_count };

QString source_text(CutterSource source) {
  switch (source) {
    case CutterSource::asked:
      return ReadingDialog::tr("set here");
    case CutterSource::program:
      return ReadingDialog::tr("program");
    case CutterSource::table:
      return ReadingDialog::tr("tool table");
    default:
      return ReadingDialog::tr("unknown: the programmed contour is shown");
  }
}

/// A length of 0 or more; none for anything else.
std::optional<double> length_of(const QString& text) {
  const auto length = number_of(text);
  return length && *length >= 0 && *length <= largest_radius ? length : std::nullopt;
}

}  // namespace

ReadingDialog::ReadingDialog(const ReadOptions& options, const Program* program, QWidget* parent)
    : QDialog(parent),
      dialect_(new QComboBox(this)),
      unit_(new QComboBox(this)),
      skip_deleted_(new QCheckBox(tr("Skip blocks that begin with /"), this)),
      repeat_limit_(new WholeNumberBox(this)),
      call_depth_(new WholeNumberBox(this)),
      simulate_cut_off_(new QCheckBox(tr("Simulate a program that was cut off at this limit"), this)),
      wear_only_(new QCheckBox(tr("Path already compensated (wear only): radius 0"), this)),
      cutters_(new QTableWidget(this)),
      offsets_(new WorkOffsetsTable(options.offsets, program, this)),
      tool_table_(new QLineEdit(this)),
      table_unit_(new QComboBox(this)),
      fault_(new QLabel(this)),
      buttons_(new QDialogButtonBox(
          QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults, this)) {
  setWindowTitle(tr("Program import options"));
  list_dialects(program);
  list_units(program);
  list_cutters(options, program);
  make_layout();
  show_options(options);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons_->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, [this] {
    for (int row = 0; row < cutters_->rowCount(); ++row) {
      cutters_->item(row, radius_column)->setText({});
    }
    offsets_->clear_offsets();
    show_options({});
  });
  connect(offsets_, &QTableWidget::itemChanged, this, &ReadingDialog::check);
  connect(cutters_, &QTableWidget::itemChanged, this, &ReadingDialog::check);
  check();
}

void ReadingDialog::list_dialects(const Program* program) {
  dialect_->setAccessibleName(tr("Dialect of the program"));
  const QString found =
      program == nullptr ? QString() : QString::fromUtf8(info_of(program->dialect).title.data());
  dialect_->addItem(found.isEmpty() ? tr("auto-detected") : tr("auto-detected (now %1)").arg(found),
                    recognised);
  for (const DialectInfo& info : all_dialects()) {
    dialect_->addItem(QString::fromUtf8(info.title.data()), static_cast<int>(info.dialect));
  }
}

void ReadingDialog::list_units(const Program* program) {
  unit_->setAccessibleName(tr("Unit of the program"));
  const bool says_it = program != nullptr && program->unit.source == ProgramUnit::Source::program;
  const QString now =
      program == nullptr ? QString() : QString::fromUtf8(to_string(program->unit.unit).data());
  unit_->addItem(says_it ? tr("as programmed (now %1)").arg(now) : tr("as programmed, otherwise mm"),
                 unit_of_program);
  unit_->addItem(tr("mm"), static_cast<int>(LengthUnit::mm));
  unit_->addItem(tr("inch"), static_cast<int>(LengthUnit::inch));
  unit_->setToolTip(
      tr("Unit of lengths and feeds until the program sets one: G20, G21, G70, G71, BEGIN PGM ... MM"));
}

/// Lists the tools that the program uses, and others in `options`; the cell of a radius contains that of
/// `options`.
void ReadingDialog::list_cutters(const ReadOptions& options, const Program* program) {
  cutters_->setAccessibleName(tr("Cutter radii"));
  cutters_->setColumnCount(column_count);
  cutters_->setHorizontalHeaderLabels(
      {tr("Tool"), with_unit_of(tr("Radius"), Dimension::length), tr("Source")});
  cutters_->verticalHeader()->hide();
  cutters_->horizontalHeader()->setStretchLastSection(true);
  CutterRadii others = options.radii;
  for (const CutterUse& use : program == nullptr ? std::vector<CutterUse>() : program->cutters) {
    const std::optional<double> own = options.radii.find(use.tool);
    const bool found = use.source == CutterSource::program || use.source == CutterSource::table;
    add_cutter(
        use.tool, own,
        found ? tr("%1: %2").arg(source_text(use.source), significant_text(use.radius, Dimension::length, 7))
              : source_text(use.source));
    others.erase(use.tool);
  }
  for (const auto& [tool, radius] : others.all()) {
    add_cutter(tool, radius, tr("set here, not used by the program"));
  }
}

void ReadingDialog::add_cutter(const std::string& tool, std::optional<double> own, const QString& source) {
  const int row = cutters_->rowCount();
  cutters_->insertRow(row);
  cutters_->setItem(row, tool_column, fixed_item(QString::fromStdString(tool)));
  auto* radius =
      new QTableWidgetItem(own ? editable_text(in_shown_unit(*own, Dimension::length)) : QString());
  radius->setToolTip(tr("Empty: the radius of the program or the tool table"));
  cutters_->setItem(row, radius_column, radius);
  cutters_->setItem(row, source_column, fixed_item(source));
}

void ReadingDialog::make_layout() {
  for (WholeNumberBox* box : {repeat_limit_, call_depth_}) {
    box->setGroupSeparatorShown(true);
    box->setMinimum(1);
  }
  repeat_limit_->setMaximum(max_lines);
  repeat_limit_->setSingleStep(lines_a_step);
  repeat_limit_->setToolTip(tr("Endless loops are cut off at this limit"));
  call_depth_->setMaximum(max_calls);
  tool_table_->setPlaceholderText(tr("a table in the folder of the program, if there is one"));
  tool_table_->setToolTip(tr(
      "LinuxCNC, Sinumerik, Fanuc (G10) or Heidenhain (TOOL.T) format, or a list with the headings T and R"));
  table_unit_->addItem(tr("mm"), 1.0);
  table_unit_->addItem(tr("inch"), units::from_inch(1));
  table_unit_->setToolTip(tr("Unit of a tool table that does not state it"));
  auto* browse = new QPushButton(tr("Choose …"), this);
  browse->setAutoDefault(false);
  connect(browse, &QPushButton::clicked, this, &ReadingDialog::choose_table);

  auto* table_row = new QHBoxLayout;
  table_row->addWidget(tool_table_, 1);
  table_row->addWidget(browse);
  table_row->addWidget(table_unit_);
  auto* form = new QFormLayout(this);
  form->addRow(tr("Dialect"), dialect_);
  form->addRow(tr("Unit"), unit_);
  form->addRow(QString(), skip_deleted_);
  form->addRow(tr("Maximum lines executed by loops and calls"), repeat_limit_);
  form->addRow(QString(), simulate_cut_off_);
  form->addRow(tr("Maximum call depth"), call_depth_);
  form->addRow(tr("Tool table"), table_row);
  if (cutters_->rowCount() > 0) {
    form->addRow(tr("Cutter radii"), cutters_);
  } else {
    cutters_->hide();
    form->addRow(tr("Cutter radii"), new QLabel(tr("The program uses no cutter radius compensation."), this));
  }
  wear_only_->setToolTip(
      tr("For programs whose CAM system has already compensated the tool radius; a radius that is set here "
         "still applies"));
  form->addRow(QString(), wear_only_);
  if (offsets_->rowCount() > 0) {
    form->addRow(tr("Work offsets"), offsets_);
  } else {
    offsets_->hide();
  }
  fault_->setWordWrap(true);
  form->addRow(fault_);
  form->addRow(buttons_);
  resize(680, sizeHint().height());
}

void ReadingDialog::show_options(const ReadOptions& options) {
  dialect_->setCurrentIndex(
      dialect_->findData(options.dialect ? static_cast<int>(*options.dialect) : recognised));
  unit_->setCurrentIndex(unit_->findData(options.unit ? static_cast<int>(*options.unit) : unit_of_program));
  skip_deleted_->setChecked(options.skip_deleted_blocks);
  repeat_limit_->setValue(static_cast<int>(std::min<std::uint64_t>(options.repeat_limit, max_lines)));
  simulate_cut_off_->setChecked(options.simulate_cut_off);
  wear_only_->setChecked(options.wear_only);
  call_depth_->setValue(static_cast<int>(std::min<std::size_t>(options.call_depth, max_calls)));
  tool_table_->setText(to_qstring(options.tool_table));
  table_unit_->setCurrentIndex(options.table_unit == 1 ? 0 : 1);
}

ReadOptions ReadingDialog::options() const {
  ReadOptions options;
  if (const int dialect = dialect_->currentData().toInt(); dialect != recognised) {
    options.dialect = static_cast<Dialect>(dialect);
  }
  if (const int unit = unit_->currentData().toInt(); unit != unit_of_program) {
    options.unit = static_cast<LengthUnit>(unit);
  }
  options.skip_deleted_blocks = skip_deleted_->isChecked();
  options.repeat_limit = static_cast<std::uint64_t>(repeat_limit_->value());
  options.call_depth = static_cast<std::size_t>(call_depth_->value());
  options.simulate_cut_off = simulate_cut_off_->isChecked();
  options.wear_only = wear_only_->isChecked();
  if (const QString table = tool_table_->text().trimmed(); !table.isEmpty()) {
    options.tool_table = std::filesystem::absolute(to_path(table));
  }
  options.table_unit = table_unit_->currentData().toDouble();
  for (int row = 0; row < cutters_->rowCount(); ++row) {
    if (const auto radius = length_of(cutters_->item(row, radius_column)->text())) {
      options.radii.set(cutters_->item(row, tool_column)->text().toStdString(),
                        from_shown_unit(*radius, Dimension::length));
    }
  }
  options.offsets = offsets_->offsets();
  return options;
}

QString ReadingDialog::fault() const {
  for (int row = 0; row < cutters_->rowCount(); ++row) {
    const QString text = cutters_->item(row, radius_column)->text();
    if (!text.trimmed().isEmpty() && !length_of(text)) {
      return tr("The radius of tool %1, \"%2\", is not a length of 0 or more.")
          .arg(cutters_->item(row, tool_column)->text(), text);
    }
  }
  return offsets_->fault();
}

void ReadingDialog::check() {
  fault_->setText(fault());
  fault_->setVisible(!valid());
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(valid());
}

void ReadingDialog::choose_table() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Choose a tool table"), tool_table_->text());
  if (!file.isEmpty()) {
    tool_table_->setText(file);
  }
}

}  // namespace feedscope::ui
