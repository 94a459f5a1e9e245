#include "ui/identification/test_program_dialog.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSaveFile>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/identification/part_times.h"
#include "ui/fields/focus_outline.h"
#include "ui/fields/number_box.h"
#include "ui/language/core_texts.h"
#include "ui/language/shown_numbers.h"
#include "ui/language/texts.h"
#include "ui/shared/paths.h"
#include "ui/shared/row_copy.h"

namespace feedscope::ui {
namespace {

/// Dialects with a test program, and the usual ending of their files.
struct TestDialect {
  Dialect dialect;
  const char* extension;
};
constexpr std::array test_dialects{
    TestDialect{Dialect::fanuc, "nc"},     TestDialect{Dialect::sinumerik, "mpf"},
    TestDialect{Dialect::heidenhain, "h"}, TestDialect{Dialect::linuxcnc, "ngc"},
    TestDialect{Dialect::grbl, "gcode"},   TestDialect{Dialect::iso, "nc"}};

constexpr double least_side = 20;                      // [mm]
constexpr double most_side = 2000;                     // [mm]
const double least_feed = units::from_mm_min(100);     // [mm/s]
const double most_feed = units::from_mm_min(100'000);  // [mm/s]
constexpr QSize first_size{1000, 460};
constexpr int line_column = 0;
constexpr int time_column = 2;
constexpr int tells_column = 3;

}  // namespace

TestProgramDialog::TestProgramDialog(Dialect dialect, Setup setup, const std::filesystem::path& folder,
                                     QWidget* parent)
    : QDialog(parent),
      setup_(std::move(setup)),
      folder_(folder),
      dialect_(new QComboBox(this)),
      side_(new NumberBox(this)),
      feed_(new NumberBox(this)),
      room_(new QLabel(this)),
      parts_(new QTreeWidget(this)),
      state_(new QLabel(this)),
      write_(new QPushButton(tr("&Write program …"), this)),
      open_(new QPushButton(tr("&Open it here"), this)) {
  setWindowTitle(tr("Test program"));
  resize(first_size);
  for (const TestDialect& one : test_dialects) {
    dialect_->addItem(QString::fromUtf8(info_of(one.dialect).title.data()), static_cast<int>(one.dialect));
  }
  dialect_->setCurrentIndex(std::max(0, dialect_->findData(static_cast<int>(dialect))));
  const IdentificationProgramRequest usual;
  side_->setDecimals(decimals_of(Dimension::length, 0));
  side_->setRange(in_shown_unit(least_side, Dimension::length), in_shown_unit(most_side, Dimension::length));
  side_->setSuffix(' ' + unit_of(Dimension::length));
  side_->setValue(in_shown_unit(usual.size, Dimension::length));
  side_->setToolTip(tr("The program keeps to this square in X and Y about the zero point"));
  feed_->setDecimals(decimals_of(Dimension::feed, 0));
  feed_->setRange(in_shown_unit(least_feed, Dimension::feed), in_shown_unit(most_feed, Dimension::feed));
  feed_->setSuffix(' ' + unit_of(Dimension::feed));
  feed_->setValue(in_shown_unit(usual.feed_max, Dimension::feed));
  feed_->setToolTip(
      tr("As fast as the machine may feed: only rapids show higher velocities, if anything does"));
  room_->setWordWrap(true);
  parts_->setHeaderLabels({tr("Line"), tr("Part"), tr("Time"), tr("What a recording of it tells")});
  parts_->headerItem()->setToolTip(time_column, tr("On %1").arg(QString::fromStdString(setup_.machine.name)));
  parts_->setAccessibleName(tr("Parts of the test program"));
  parts_->setRootIsDecorated(false);
  parts_->setWordWrap(true);
  parts_->setAlternatingRowColors(true);
  parts_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  parts_->header()->setSectionResizeMode(tells_column, QHeaderView::Stretch);
  install_row_copy(*parts_);
  new FocusOutline(*parts_);
  state_->setWordWrap(true);
  state_->setTextFormat(Qt::PlainText);
  state_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  open_->setToolTip(tr("Opens the program that was written, to lay its trace beside it"));
  make_layout();
  connect(dialect_, &QComboBox::currentIndexChanged, this, &TestProgramDialog::refresh);
  for (NumberBox* box : {side_, feed_}) {
    connect(box, &NumberBox::valueChanged, this, &TestProgramDialog::refresh);
  }
  connect(write_, &QPushButton::clicked, this, &TestProgramDialog::ask_and_write);
  connect(open_, &QPushButton::clicked, this, [this] {
    const std::filesystem::path file = written_;
    accept();
    emit open_wanted(file);
  });
  refresh();
}

void TestProgramDialog::make_layout() {
  auto* form = new QFormLayout;
  form->addRow(tr("&Control"), dialect_);
  form->addRow(tr("&Side of the square"), side_);
  form->addRow(tr("Largest &feed"), feed_);
  auto* close = new QPushButton(tr("Close"), this);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  close->setAutoDefault(false);
  open_->setAutoDefault(false);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  buttons->addWidget(write_);
  buttons->addWidget(open_);
  buttons->addWidget(close);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(room_);
  layout->addWidget(parts_, 1);
  layout->addWidget(state_);
  layout->addLayout(buttons);
}

IdentificationProgramRequest TestProgramDialog::request() const {
  IdentificationProgramRequest request;
  request.dialect = static_cast<Dialect>(dialect_->currentData().toInt());
  request.size = std::clamp(from_shown_unit(side_->value(), Dimension::length), least_side, most_side);
  request.feed_max = std::clamp(from_shown_unit(feed_->value(), Dimension::feed), least_feed, most_feed);
  return request;
}

QString TestProgramDialog::proposed_name() const {
  const auto* const known = std::ranges::find(test_dialects, request().dialect, &TestDialect::dialect);
  return QStringLiteral("feedscope-test.%1").arg(QLatin1String(known->extension));
}

void TestProgramDialog::refresh() {
  const IdentificationProgramRequest asked = request();
  const IdentificationProgram made = identification_program(asked);
  room_->setText(
      tr("Put the zero point in the middle of a free square of %1 with nothing below or around the tool: Z "
         "goes up from it by %2, never below. Controls of Fanuc and SINUMERIK take the times of its %3 "
         "sections "
         "themselves; the others need a trace.")
          .arg(amount_text(asked.size, Dimension::length, 0), amount_text(made.height, Dimension::length, 0))
          .arg(made.sections));
  parts_->clear();
  const std::vector<QString> times = times_of(made);
  for (std::size_t i = 0; i < made.parts.size(); ++i) {
    const IdentificationProgramPart& part = made.parts[i];
    auto* row = new QTreeWidgetItem(parts_, {QString::number(part.line), QString::fromStdString(part.title),
                                             times[i], core_text(part.tells)});
    for (const int column : {line_column, time_column}) {
      row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    row->setToolTip(tells_column, row->text(tells_column));
  }
  written_.clear();
  open_->setEnabled(false);
  state_->clear();
}

/// Times on the machine of the window; "–" if that cannot run a part.
std::vector<QString> TestProgramDialog::times_of(const IdentificationProgram& program) const {
  std::vector<QString> texts(program.parts.size(), QStringLiteral("–"));
  try {
    ReadOptions reading;
    reading.dialect = request().dialect;
    const LoadedProgram read =
        load_program(std::make_shared<const SourceText>("test", program.text), nullptr, reading);
    const std::vector<LineTime> times =
        part_times(program, setup_.model->simulate(read.toolpath, setup_.machine, setup_.settings));
    std::ranges::transform(times, texts.begin(), [](const LineTime& part) { return clock_text(part.time); });
  } catch (const InputError&) {
    // An axis of the machine has no limit: the times are unknown.
  }
  return texts;
}

void TestProgramDialog::ask_and_write() {
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Write the test program"), to_qstring(folder_ / to_path(proposed_name())),
      tr("NC programs (*.nc *.ngc *.gcode *.mpf *.h);;All files (*)"));
  if (!file.isEmpty()) {
    write(to_path(file));
  }
}

bool TestProgramDialog::write(const std::filesystem::path& file) {
  const std::string text = identification_program(request()).text;
  QSaveFile out(to_qstring(file));
  const auto size = static_cast<qint64>(text.size());
  const bool done = out.open(QIODevice::WriteOnly) && out.write(text.data(), size) == size && out.commit();
  written_ = done ? file : std::filesystem::path();
  open_->setEnabled(done);
  state_->setText(
      done ? tr("%1 is written. Run it on the machine, record X, Y and Z meanwhile, open it here and "
                "then the trace.")
                 .arg(to_qstring(file.filename()))
           : tr("%1 cannot be written: %2. Choose another folder.").arg(to_qstring(file), out.errorString()));
  return done;
}

QString TestProgramDialog::state() const {
  return state_->text();
}

}  // namespace feedscope::ui
