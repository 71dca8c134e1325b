#include "ui/waypoints/waypoint_transfer.h"

#include <algorithm>
#include <map>

#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMimeData>

#include "disk/file_error.h"
#include "disk/read_file.h"
#include "disk/written_file.h"
#include "exchange/waypoint_table.h"
#include "exchange/waypoint_json.h"
#include "sentences/fault_sentence.h"
#include "ui/kit/folders.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"
#include "ui/view/tool_choice.h"
#include "ui/waypoints/waypoint_text.h"
#include "words/qt_plain.h"

namespace mapwright::window {

namespace {

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
                            .tip = tr("From a GeoJSON or CSV file, with a preview of the changes"),
                            .menu = {MenuGroup::Waypoints, 54}},
                           this, [this] {
                             const QString path = QFileDialog::getOpenFileName(
                                 &context_.window, tr("Import waypoints"), lastMapFolder(context_.settings),
                                 tr("Waypoints (*.geojson *.json *.csv *.tsv *.txt)"));
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
  context_.overlay.toasts()->add(good ? Mark::Good : Mark::Bad, text);
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
  const auto points = listed(&editing_->selected());
  if (points.empty()) return;
  auto* const mime = new QMimeData;
  mime->setData(QLatin1String(kMime),
                exchange::waypointsGeoJson(points, map_ ? map::toText(*map_) : std::string()));
  mime->setText(words::plainText(QString::fromStdString(exchange::waypointsTable(points))));
  QGuiApplication::clipboard()->setMimeData(mime);
  say(true, tr("%1 copied").arg(waypointsText(qsizetype(points.size()))));
}

void WaypointTransfer::paste() {
  if (!editing_->editable()) return;
  const QMimeData* const mime = QGuiApplication::clipboard()->mimeData();
  if (mime && mime->hasFormat(QLatin1String(kMime)))
    return pasteCopied(mime->data(QLatin1String(kMime)).toStdString());
  if (!mime || mime->text().trimmed().isEmpty())
    return say(false,
               tr("The clipboard contains no waypoints and no table. Copy rows of a spreadsheet first."));
  ask({ImportSource::Kind::Table, {}, mime->text().toStdString()});
}

void WaypointTransfer::pasteCopied(const std::string& geojson) {
  auto wanted = exchange::wantedFromGeoJson(geojson);
  if (!wanted) return say(false, tr("The clipboard cannot be pasted. %1").arg(wanted.error()));
  std::set<std::string> taken;
  std::map<std::string, int> numbers;
  for (const auto& [key, point] : editing_->document()->items()) taken.insert(point.name);
  // As new ones: in another map these ids are meaningless, in this one they belong to others.
  for (exchange::WantedWaypoint& one : wanted->points) {
    one.id.clear();
    if (one.name) one.name = freeName(*one.name, taken, numbers);
  }
  exchange::nameNameless(wanted->points, editing_->document()->items(), tr("Waypoint %1"));
  auto edits = exchange::editsFor({}, wanted->points, exchange::Others::Go);
  if (!edits) return say(false, tr("The clipboard cannot be pasted. %1").arg(edits.error()));
  exchange::FittedEdits fitted = exchange::fitted(std::move(*edits), editing_->keeps());
  for (auto& edit : fitted.edits) {
    if (edit.after) edit.after->id = edit.key;
  }
  QStringList said{tr("%1 pasted").arg(waypointsText(qsizetype(fitted.edits.size())))};
  editing_->make(std::move(fitted.edits), tr("paste %1"));
  context_.overlay.toasts()->add(fitted.notes.isEmpty() ? Mark::Good : Mark::Warning,
                                 (said + fitted.notes).join(QLatin1Char('\n')));
}

void WaypointTransfer::importFile(const QString& path) {
  const QString name = words::plainName(QFileInfo(path).fileName()).left(120);
  auto bytes = disk::readFile(path.toStdString(), exchange::kMaxWantedBytes + 1);
  if (!bytes)
    return say(false, tr("%1 cannot be read: %2.").arg(name, sentences::wordsOf(bytes.error().cause)));
  if (bytes->size() > exchange::kMaxWantedBytes) return say(false, tr("%1 is larger than 64 MiB.").arg(name));
  ask({isCsv(path) ? ImportSource::Kind::Table : ImportSource::Kind::GeoJson, name, std::move(*bytes)});
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
                .arg(waypointsText(qsizetype(points.size())),
                     words::plainName(QFileInfo(path).fileName()).left(80)));
}

bool WaypointTransfer::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &context_.view && event->type() == QEvent::KeyPress && context_.tools.chosen() == tool_) {
    const auto* press = static_cast<QKeyEvent*>(event);
    if (press->matches(QKeySequence::Copy) && copy_->isEnabled()) return copy(), true;
    if (press->matches(QKeySequence::Paste) && paste_->isEnabled()) return paste(), true;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace mapwright::window

#include "moc_waypoint_transfer.cpp"
