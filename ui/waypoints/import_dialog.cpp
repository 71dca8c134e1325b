#include "ui/waypoints/import_dialog.h"

#include <algorithm>
#include <map>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "exchange/waypoint_json.h"
#include "sentences/plural.h"
#include "ui/kit/ui_colors.h"
#include "ui/waypoints/waypoint_text.h"
#include "words/qt_plain.h"

namespace mapwright::window {

namespace {

constexpr int kMostRows = 2'000;  // the others are only counted
constexpr int kImportRowPx = 24;

QString becomes(exchange::StepKind kind) {
  using exchange::StepKind;
  switch (kind) {
    case StepKind::Create:
      return ImportDialog::tr("new");
    case StepKind::Move:
      return ImportDialog::tr("moved");
    case StepKind::Rename:
      return ImportDialog::tr("renamed");
    case StepKind::Retag:
      return ImportDialog::tr("retagged");
    case StepKind::Retype:
      return ImportDialog::tr("of another kind");
    case StepKind::Delete:
      break;
  }
  return ImportDialog::tr("deleted");
}

}  // namespace

ImportDialog::ImportDialog(ImportSource source, exchange::WaypointItems kept, const robot::KeptFields& keeps,
                           QWidget* parent)
    : QDialog(parent),
      source_(std::move(source)),
      kept_(std::move(kept)),
      keeps_(keeps),
      table_(new QTableWidget(0, 3, this)),
      status_(new QLabel(this)),
      header_(new QCheckBox(tr("First row contains the &column names"), this)),
      comma_(new QCheckBox(tr("&Decimal commas"), this)),
      others_(new QCheckBox(tr("Delete waypoints that are &not in it"), this)),
      separator_(new QComboBox(this)),
      turns_(new QComboBox(this)),
      apply_(new QPushButton(tr("&Apply"), this)) {
  setObjectName(QStringLiteral("importWaypoints"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(source_.name.isEmpty() ? tr("Paste waypoints")
                                        : tr("Import %1").arg(words::plainName(source_.name)));
  resize(720, 420);
  table_->setTabKeyNavigation(false);
  separator_->addItem(tr("Tabs"), QChar(u'\t'));
  separator_->addItem(tr("Commas"), QChar(u','));
  separator_->addItem(tr("Semicolons"), QChar(u';'));
  separator_->setAccessibleName(tr("Column separator"));
  turns_->addItem(tr("Headings in degrees"), true);
  turns_->addItem(tr("Headings in radians"), false);
  turns_->setAccessibleName(tr("Unit of headings"));
  turns_->setToolTip(tr("A column called yaw_rad is always in radians"));
  if (source_.kind == ImportSource::Kind::Table) {
    const exchange::TableShape shape = exchange::shapeOf(source_.text);
    header_->setChecked(shape.header);
    comma_->setChecked(shape.decimal_comma);
    separator_->setCurrentIndex(separator_->findData(QChar::fromLatin1(shape.separator)));
  } else {
    for (QWidget* of_tables : std::initializer_list<QWidget*>{header_, comma_, separator_, turns_})
      of_tables->hide();
  }
  table_->setHorizontalHeaderLabels({tr("Waypoint"), tr("Change"), tr("What changes")});
  table_->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeader()->resizeSection(0, 180);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(kImportRowPx);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setShowGrid(false);
  table_->setWordWrap(false);
  table_->setAccessibleName(tr("What changes"));
  status_->setTextFormat(Qt::PlainText);
  status_->setWordWrap(true);
  apply_->setDefault(true);
  auto* const cancel = new QPushButton(tr("Cancel"), this);

  auto* shape = new QHBoxLayout;
  for (QWidget* choice : std::initializer_list<QWidget*>{separator_, header_, comma_, turns_})
    shape->addWidget(choice);
  shape->addStretch();
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(others_);
  buttons->addStretch();
  buttons->addWidget(cancel);
  buttons->addWidget(apply_);
  auto* column = new QVBoxLayout(this);
  column->addLayout(shape);
  column->addWidget(table_, 1);
  column->addWidget(status_);
  column->addLayout(buttons);

  for (QCheckBox* box : {header_, comma_, others_})
    connect(box, &QCheckBox::toggled, this, &ImportDialog::look);
  for (QComboBox* box : {separator_, turns_})
    connect(box, &QComboBox::currentIndexChanged, this, &ImportDialog::look);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(apply_, &QPushButton::clicked, this, [this] {
    Q_EMIT chosen(edits_);
    accept();
  });
  look();
}

void ImportDialog::look() {
  edits_.clear();
  exchange::WantedFile wanted;
  if (source_.kind == ImportSource::Kind::GeoJson) {
    wanted = exchange::wantedFromGeoJson(source_.text);
  } else {
    exchange::TableShape shape;
    shape.separator = separator_->currentData().toChar().toLatin1();
    shape.header = header_->isChecked();
    shape.decimal_comma = comma_->isChecked();
    shape.turns_in_degrees = turns_->currentData().toBool();
    wanted = exchange::wantedFromTable(source_.text, shape);
  }
  QString problem;
  QStringList notes;
  if (wanted) {
    notes = wanted->notes;
    exchange::nameNameless(wanted->points, kept_, tr("Waypoint %1"));
    auto edits = exchange::editsFor(kept_, wanted->points,
                                    others_->isChecked() ? exchange::Others::Go : exchange::Others::Stay);
    if (edits) {
      exchange::FittedEdits fitted = exchange::fitted(std::move(*edits), keeps_);
      edits_ = std::move(fitted.edits);
      notes = fitted.notes + notes;
    } else {
      problem = edits.error();
    }
  } else {
    problem = wanted.error();
  }
  const auto steps = exchange::stepsOf(edits_);
  fill(steps);
  apply_->setEnabled(!edits_.empty());
  const UiColors colors = appColors();
  QPalette palette = status_->palette();
  palette.setColor(QPalette::WindowText, problem.isEmpty() ? colors.text : colors.error_text);
  status_->setPalette(palette);
  if (!problem.isEmpty()) return status_->setText(problem);
  std::map<exchange::StepKind, int> counts;
  for (const auto& step : steps) ++counts[step.kind];
  QStringList parts;
  for (const auto& [kind, count] : counts)
    parts << QStringLiteral("%1 %2").arg(QLocale::c().toString(count), becomes(kind));
  QString text = parts.isEmpty()
                     ? tr("Nothing changes: these waypoints are already here.")
                     : tr("%1. Nothing has been sent or saved yet.").arg(parts.join(QStringLiteral(", ")));
  if (int(steps.size()) > kMostRows)
    text += QLatin1Char(' ') + tr("Only the first %1 are shown.").arg(kMostRows);
  for (const QString& note : notes.mid(0, 3)) text += QLatin1Char('\n') + note;
  status_->setText(text);
}

void ImportDialog::fill(const std::vector<exchange::WaypointStep>& steps) {
  const int rows = std::min(int(steps.size()), kMostRows);
  table_->setRowCount(rows);
  namespace field = edit::waypoint_field;
  for (int row = 0; row < rows; ++row) {
    const exchange::WaypointStep& step = steps[std::size_t(row)];
    // Only of this step: an edit may have several.
    std::optional<map::Waypoint> after = step.after;
    if (step.before && step.after) {
      const edit::FieldMask fields = step.kind == exchange::StepKind::Rename  ? field::kName
                                     : step.kind == exchange::StepKind::Retag ? field::kTags
                                     : step.kind == exchange::StepKind::Retype
                                         ? field::kType
                                         : field::kPosition | field::kYaw;
      after = step.before;
      edit::assign(*after, *step.after, fields);
    }
    const QString cells[] = {shortWaypointName(step.before ? *step.before : *step.after), becomes(step.kind),
                             step.after ? changeText(step.before, after) : QString()};
    for (int column = 0; column < 3; ++column)
      table_->setItem(row, column, new QTableWidgetItem(cells[column]));
  }
}

QString ImportDialog::statusShown() const { return status_->text(); }

}  // namespace mapwright::window

#include "moc_import_dialog.cpp"
