#include "ui/waypoints/waypoint_transfer.h"

#include <algorithm>
#include <array>
#include <map>

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>
#include <QMimeData>
#include <QPushButton>
#include <QTableWidget>

#include "disk/file_error.h"
#include "disk/read_file.h"
#include "disk/written_file.h"
#include "exchange/waypoint_json.h"
#include "exchange/waypoint_plan.h"
#include "exchange/waypoint_table.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "ui/kit/actions.h"
#include "ui/kit/folders.h"
#include "ui/kit/forms.h"
#include "ui/kit/name_column.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"
#include "ui/view/tool_choice.h"
#include "ui/waypoints/waypoint_text.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {
namespace {

/// What was copied, for the clipboard: the texts are made when another program, or another window of this
/// one's, asks for them.
class CopiedWaypoints : public QMimeData {
 public:
  CopiedWaypoints(std::vector<map::Waypoint> points, std::string map)
      : points_(std::move(points)), map_(std::move(map)) {}
  const std::vector<map::Waypoint>& points() const { return points_; }
  QStringList formats() const override {
    return {QLatin1String(WaypointTransfer::kMime), QStringLiteral("text/plain")};
  }

 protected:
  QVariant retrieveData(const QString& format, QMetaType) const override {
    if (format == QLatin1String(WaypointTransfer::kMime)) return exchange::waypointsGeoJson(points_, map_);
    if (format != QLatin1String("text/plain")) return {};
    return words::plainText(QString::fromStdString(exchange::waypointsTable(points_)));
  }

 private:
  std::vector<map::Waypoint> points_;
  std::string map_;
};

/// With keys of their own.
std::vector<exchange::WantedWaypoint> asNew(const std::vector<map::Waypoint>& points) {
  std::vector<exchange::WantedWaypoint> wanted;
  wanted.reserve(points.size());
  for (const map::Waypoint& point : points) {
    exchange::WantedWaypoint one{.row = int(wanted.size()) + 1, .id = exchange::freshKey()};
    if (!point.name.empty()) one.name = point.name;
    if (!point.type.empty()) one.type = point.type;
    one.position_m = point.position_m;
    one.yaw_rad = point.yaw_rad;
    one.tags = point.tags;
    wanted.push_back(std::move(one));
  }
  return wanted;
}

constexpr int kMostRows = 2'000;  // the others are only counted
constexpr int kImportRowPx = 24;

QString becomes(exchange::StepKind kind) {
  const std::array<QString, 6> words{
      ImportDialog::tr("new"),      ImportDialog::tr("moved"),           ImportDialog::tr("renamed"),
      ImportDialog::tr("retagged"), ImportDialog::tr("of another kind"), ImportDialog::tr("deleted")};
  return words[std::size_t(kind)];
}

bool isCsv(const QString& path) {
  const QString ending = QFileInfo(path).suffix().toLower();
  return ending == QLatin1String("csv") || ending == QLatin1String("tsv") || ending == QLatin1String("txt");
}

/// "Dock 2", a name that nobody has.
std::string freeName(const std::string& like, std::set<std::string>& taken,
                     std::map<std::string, int>& numbers) {
  std::string name = like;
  int& number = numbers.try_emplace(like, 1).first->second;
  while (!taken.insert(name).second) name = like + " " + std::to_string(++number);
  return name;
}

}  // namespace

ImportDialog::ImportDialog(ImportSource source, exchange::WaypointItems kept, const robot::KeptFields& keeps,
                           QWidget* parent)
    : QDialog(parent),
      source_(std::move(source)),
      kept_(std::move(kept)),
      keeps_(keeps),
      table_(new QTableWidget(0, 3, this)),
      status_(wrappedLabel({}, this)),
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
  turns_->addItem(tr("Headings as they look"), int(exchange::AngleUnit::Guess));
  turns_->addItem(tr("Headings in degrees"), int(exchange::AngleUnit::Degrees));
  turns_->addItem(tr("Headings in radians"), int(exchange::AngleUnit::Radians));
  turns_->setAccessibleName(tr("Unit of headings"));
  turns_->setToolTip(tr("For headings whose name has no unit: yaw_rad is always in radians"));
  if (isTable()) {
    const exchange::TableShape shape = exchange::shapeOf(source_.text);
    header_->setChecked(shape.header);
    comma_->setChecked(shape.decimal_comma);
    separator_->setCurrentIndex(separator_->findData(QChar::fromLatin1(shape.separator)));
  } else {
    for (QWidget* of_tables : std::initializer_list<QWidget*>{header_, comma_, separator_}) of_tables->hide();
  }
  table_->setHorizontalHeaderLabels({tr("Waypoint"), tr("Change"), tr("What changes")});
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeader()->resizeSection(0, 180);
  new NameColumn(table_, table_->horizontalHeader(), 2, {{1, 60}, {0, 120}});
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(kImportRowPx);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setShowGrid(false);
  table_->setWordWrap(false);
  table_->setAccessibleName(tr("What changes"));
  if (const QString stays = exchange::notRemovedReason(keeps_); !stays.isEmpty()) {
    others_->setEnabled(false);
    others_->setToolTip(plainToolTip(stays));
  }
  apply_->setDefault(true);
  auto* const cancel = new QPushButton(tr("Cancel"), this);

  setLayout(columnOf({rowOf({separator_, header_, comma_, turns_, LayoutItem::rest()}),
                      {table_, 1},
                      status_,
                      rowOf({others_, LayoutItem::rest(), cancel, apply_})}));

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

bool ImportDialog::isTable() const { return source_.format == exchange::WaypointFormat::Table; }

void ImportDialog::look() {
  edits_.clear();
  exchange::WantedFile wanted;
  const auto angles = exchange::AngleUnit(turns_->currentData().toInt());
  if (!isTable()) {
    wanted = exchange::wantedFromFile(source_.text, source_.format, angles);
  } else {
    exchange::TableShape shape;
    shape.separator = separator_->currentData().toChar().toLatin1();
    shape.header = header_->isChecked();
    shape.decimal_comma = comma_->isChecked();
    shape.angles = angles;
    shape.ragged = source_.name.isEmpty();
    wanted = exchange::wantedFromTable(source_.text, shape);
  }
  QString problem;
  QStringList notes;
  if (wanted) {
    notes = wanted->notes;
    exchange::knowByPlace(wanted->points, kept_);
    notes << exchange::nameNameless(wanted->points, kept_);
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
  setTextColor(*status_, problem.isEmpty() ? appColors().text : appColors().error_text);
  if (!problem.isEmpty()) return status_->setText(problem);
  std::map<exchange::StepKind, int> counts;
  for (const auto& step : steps) ++counts[step.kind];
  QStringList parts;
  for (const auto& [kind, count] : counts)
    parts << QStringLiteral("%1 %2").arg(QLocale::c().toString(count), becomes(kind));
  QString text = parts.isEmpty() ? tr("Nothing changes: these waypoints are already here.")
                                 : tr("%1. Nothing has been sent or saved yet.").arg(words::listed(parts));
  if (int(steps.size()) > kMostRows)
    text += QLatin1Char(' ') + tr("Only the first %1 are shown.").arg(kMostRows);
  // All of them: each tells of something that is not as the file has it.
  for (const QString& note : notes) text += note.isEmpty() ? QString() : QLatin1Char('\n') + note;
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

WaypointTransfer::WaypointTransfer(WindowContext& context, WaypointEditing* editing, const MapTool* tool,
                                   QObject* parent)
    : QObject(parent), context_(context), editing_(editing), tool_(tool) {
  addActions();
  connect(editing_, &WaypointEditing::opened, this, [this] {
    if (dialog_) dialog_->close();  // it is about another list
    refresh();
  });
  connect(editing_, &WaypointEditing::selectionChanged, this, &WaypointTransfer::refresh);
  context_.view.installEventFilter(this);
  refresh();
}

void WaypointTransfer::addActions() {
  copy_ = context_.actions.add({.id = "copyWaypoints",
                                .text = tr("&Copy waypoints"),
                                .icon = "copy",
                                .tip = tr("Copy the selection, for another map or a spreadsheet"),
                                .menu = {MenuGroup::Waypoints, 50}},
                               this, &WaypointTransfer::copy);
  paste_ = context_.actions.add({.id = "pasteWaypoints",
                                 .text = tr("&Paste waypoints"),
                                 .tip = tr("Paste waypoints copied here, or rows of a spreadsheet"),
                                 .menu = {MenuGroup::Waypoints, 52}},
                                this, &WaypointTransfer::paste);
  import_ =
      context_.actions.add({.id = "importWaypoints",
                            .text = tr("&Import waypoints…"),
                            .icon = "open",
                            .tip = tr("From a GeoJSON, CSV or YAML file, with a preview of the changes"),
                            .menu = {MenuGroup::Waypoints, 54}},
                           this, [this] {
                             const QString path = QFileDialog::getOpenFileName(
                                 &context_.window, tr("Import waypoints"), lastMapFolder(context_.settings),
                                 tr("Waypoints (*.geojson *.json *.csv *.tsv *.txt *.yaml *.yml)"));
                             if (!path.isEmpty()) importFile(path);
                           });
  export_ = context_.actions.add(
      {.id = "exportWaypoints",
       .text = tr("E&xport waypoints…"),
       .icon = "export",
       .tip = tr("All waypoints of this map as GeoJSON or CSV, including unsaved changes"),
       .menu = {MenuGroup::Waypoints, 56}},
      this, [this] {
        const QString path = QFileDialog::getSaveFileName(
            &context_.window, tr("Export waypoints"),
            folderToWriteInto({lastMapFolder(context_.settings)}) + QStringLiteral("/waypoints.geojson"),
            tr("GeoJSON (*.geojson);;CSV (*.csv)"));
        if (!path.isEmpty()) exportTo(path);
      });
}

void WaypointTransfer::refresh() {
  copy_->setEnabled(editing_->document() && !editing_->selected().empty());
  paste_->setEnabled(editing_->editable());
  import_->setEnabled(editing_->editable());
  export_->setEnabled(editing_->document() != nullptr);
}

void WaypointTransfer::say(bool good, const QString& text) {
  context_.overlay.toasts()->add(good ? Mark::Good : Mark::Bad, text, {}, QStringLiteral("transfer"));
}

std::vector<map::Waypoint> WaypointTransfer::listed(const std::set<edit::Key>* only) const {
  std::vector<map::Waypoint> points;
  if (!editing_->document()) return points;
  for (const auto& [key, point] : editing_->document()->items()) {
    if (!only || only->contains(key)) points.push_back(point);
  }
  return points;
}

void WaypointTransfer::copy() {
  auto points = listed(&editing_->selected());
  if (points.empty()) return;
  const auto count = qsizetype(points.size());
  QGuiApplication::clipboard()->setMimeData(
      new CopiedWaypoints(std::move(points), map_ ? map::toText(*map_) : std::string()));
  say(true, tr("%1 copied").arg(waypointsText(count)));
}

void WaypointTransfer::paste() {
  if (!editing_->editable()) return;
  const QMimeData* const mime = QGuiApplication::clipboard()->mimeData();
  if (const auto* const mine = dynamic_cast<const CopiedWaypoints*>(mime))
    return pasteCopied(asNew(mine->points()));
  if (mime && mime->hasFormat(QLatin1String(kMime))) {
    auto wanted = exchange::wantedFromGeoJson(mime->data(QLatin1String(kMime)).toStdString());
    if (!wanted) return say(false, tr("The clipboard cannot be pasted. %1").arg(wanted.error()));
    // As new ones: in another map these ids are meaningless, in this one they belong to others.
    for (exchange::WantedWaypoint& one : wanted->points) one.id = exchange::freshKey();
    return pasteCopied(std::move(wanted->points));
  }
  if (!mime || mime->text().trimmed().isEmpty())
    return say(false,
               tr("The clipboard contains no waypoints and no table. Copy rows of a spreadsheet first."));
  ask({exchange::WaypointFormat::Table, {}, mime->text().toStdString()});
}

void WaypointTransfer::pasteCopied(std::vector<exchange::WantedWaypoint> points) {
  const auto added = addNew(std::move(points), tr("paste %1"), tr("%1 pasted"));
  if (!added) say(false, tr("The clipboard cannot be pasted. %1").arg(added.error()));
}

std::vector<edit::Key> WaypointTransfer::carryOver(const std::vector<map::Waypoint>& points) {
  if (!editing_->editable() || points.empty()) return {};
  std::vector<exchange::WantedWaypoint> wanted = asNew(points);
  std::vector<edit::Key> keys;
  for (const exchange::WantedWaypoint& one : wanted) keys.push_back(one.id);
  const auto added = addNew(std::move(wanted), tr("carry over %1"),
                            tr("%1 carried over. Nothing has been sent or saved yet."));
  if (added) return keys;
  say(false, tr("Nothing was carried over. %1").arg(added.error()));
  return {};
}

tl::expected<void, QString> WaypointTransfer::addNew(std::vector<exchange::WantedWaypoint> points,
                                                     const QString& what, const QString& made) {
  std::set<std::string> taken;
  std::map<std::string, int> numbers;
  for (const auto& [key, point] : editing_->document()->items()) taken.insert(point.name);
  for (exchange::WantedWaypoint& one : points) {
    if (one.name) one.name = freeName(*one.name, taken, numbers);
  }
  exchange::nameNameless(points, editing_->document()->items());
  auto edits = exchange::editsFor({}, points, exchange::Others::Go);
  if (!edits) return exchange::wrong(edits.error());
  exchange::FittedEdits fitted = exchange::fitted(std::move(*edits), editing_->keeps());
  for (auto& edit : fitted.edits) {
    if (edit.after) edit.after->id = edit.key;
  }
  QStringList said{made.arg(waypointsText(qsizetype(fitted.edits.size())))};
  editing_->make(std::move(fitted.edits), what);
  context_.overlay.toasts()->add(fitted.notes.isEmpty() ? Mark::Good : Mark::Warning,
                                 (said + fitted.notes).join(QLatin1Char('\n')));
  return {};
}

void WaypointTransfer::importFile(const QString& path) {
  const QString name = plainWords(QFileInfo(path).fileName(), 120);
  auto bytes = disk::readFile(path.toStdString(), exchange::kMaxWantedBytes + 1);
  if (!bytes)
    return say(false, tr("%1 cannot be read: %2.").arg(name, sentences::wordsOf(bytes.error().cause)));
  if (bytes->size() > exchange::kMaxWantedBytes) return say(false, tr("%1 is larger than 64 MiB.").arg(name));
  const auto called = exchange::waypointFormatCalled(QFileInfo(path).suffix().toLower());
  const exchange::WaypointFormat format = called ? *called : exchange::waypointFormatOf(*bytes);
  ask({format, name, std::move(*bytes)});
}

void WaypointTransfer::ask(ImportSource source) {
  if (!editing_->editable()) return;
  if (dialog_) dialog_->close();
  const bool pasted = source.name.isEmpty();
  dialog_ =
      new ImportDialog(std::move(source), editing_->document()->items(), editing_->keeps(), &context_.window);
  connect(dialog_, &ImportDialog::chosen, this, [this, pasted](std::vector<exchange::WaypointEdit> edits) {
    for (auto& edit : edits) {
      if (edit.after && edit.after->id.empty()) edit.after->id = edit.key;
    }
    editing_->make(std::move(edits), pasted ? tr("paste %1") : tr("import %1"));
  });
  dialog_->open();
}

void WaypointTransfer::exportTo(const QString& path) {
  const auto points = listed(nullptr);
  const std::string map = map_ ? map::toText(*map_) : std::string();
  const std::string bytes = isCsv(path) ? exchange::waypointsCsv(points, map)
                                        : exchange::waypointsGeoJson(points, map).toStdString();
  if (const auto fault = disk::writeFile(path.toStdString(), bytes))
    return say(false, sentences::wordsOf(disk::notWritten(*fault)));
  say(true, tr("%1 written to %2")
                .arg(waypointsText(qsizetype(points.size())), plainWords(QFileInfo(path).fileName(), 80)));
}

bool WaypointTransfer::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &context_.view && event->type() == QEvent::KeyPress && context_.tools.chosen() == tool_) {
    const auto* press = static_cast<QKeyEvent*>(event);
    if (press->matches(QKeySequence::Copy) && copy_->isEnabled()) return copy(), true;
    if (press->matches(QKeySequence::Paste) && paste_->isEnabled()) return paste(), true;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_waypoint_transfer.cpp"
