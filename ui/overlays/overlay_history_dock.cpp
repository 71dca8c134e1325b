#include "ui/overlays/overlay_history_dock.h"

#include <algorithm>
#include <utility>

#include <QComboBox>
#include <QDateTime>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QSplitter>
#include <QTableWidget>

#include "overlays/overlay_merge.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/name_column.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/ui_colors.h"
#include "ui/overlays/overlay_text.h"
#include "words/listed.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

using history::KeptVersion;
using overlays::OverlayDocument;

namespace {

enum Column { WhenColumn, KeptColumn, NumberColumn, WhatColumn, kColumns };

constexpr std::size_t kAtOnce = 8;  // versions that are read for their words before they are shown
constexpr qsizetype kMostTold = 3;
constexpr std::size_t kMostMarks = 4'000, kMostListed = 5'000;

QString timeText(double seconds) {
  return QLocale().toString(QDateTime::fromMSecsSinceEpoch(qint64(seconds * 1000)),
                            QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

QString mapText(const history::MapName& map) {
  const QString name = words::plainName(map.name.empty() ? map.id : map.name);
  return QStringLiteral("%1 – %2").arg(name, words::plainName(map.robot));
}

tl::expected<OverlayDocument, Fault> versionIn(const tl::expected<history::VersionStore, Fault>& store,
                                               std::int64_t number) {
  if (!store) return tl::make_unexpected(store.error());
  auto text = store->text(number);
  if (!text) return tl::make_unexpected(text.error());
  return OverlayDocument::read(std::move(*text));
}

QString summaryOf(const OverlayDocument& before, const OverlayDocument& after) {
  const auto changes = overlays::changesBetween(before, after);
  QStringList told;
  for (const overlays::OverlayChange& change : changes) {
    if (told.size() == kMostTold) break;
    told << changeText(change, before, after);
  }
  if (told.isEmpty()) return OverlayHistoryDock::tr("Only how it is written");
  const auto count = qsizetype(changes.size());
  const QString sentences = words::joined(told);
  return count > kMostTold ? OverlayHistoryDock::tr("%1: %2; …").arg(overlayChangesText(count), sentences)
                           : sentences;
}

}  // namespace

OverlayHistoryDock::OverlayHistoryDock(OverlayHistory* history, const scene::MapScene* scene,
                                       OverlayMarks* marks, QWidget* parent)
    : QDockWidget(tr("Overlay history"), parent),
      history_(history),
      scene_(scene),
      marks_(marks),
      map_(new QComboBox(this)),
      against_(new QComboBox(this)),
      table_(new QuietView<QTableWidget>(this)),
      changes_(new QuietView<QListWidget>(this)),
      about_(wrappedLabel({}, this)),
      more_(wrappedLabel({}, this)),
      status_(wrappedLabel({}, this)),
      trouble_(wrappedLabel({}, this)),
      restore_(compactButton(tr("Restore this version"), this)),
      save_as_(compactButton(tr("Save as…"), this, tr("Writes this version to a GeoJSON file"))) {
  setObjectName(QStringLiteral("overlayHistory"));
  map_->setAccessibleName(tr("Map whose versions are listed"));
  map_->setToolTip(tr("Map and robot whose versions are listed"));
  map_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  map_->setMinimumContentsLength(10);
  against_->setAccessibleName(tr("Compare the selected version with"));
  against_->addItem(tr("Compared with the version before"));
  against_->addItem(tr("Compared with what is open"));
  against_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  against_->setMinimumContentsLength(10);

  table_->setColumnCount(kColumns);
  table_->setHorizontalHeaderLabels({tr("When"), tr("Kept when"), tr("Version"), tr("What changed")});
  showRows(*table_, table_->model(), tr("Versions of the overlays"), 24);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->setMinimumHeight(60);
  table_->setToolTip(tr("Select two with Ctrl to compare them"));
  QHeaderView* const header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  header->setMinimumSectionSize(26);
  const auto wide = [&](const QString& sample) { return fontMetrics().horizontalAdvance(sample) + 24; };
  header->resizeSection(WhenColumn, wide(QStringLiteral("2026-10-30 10:00:00")));
  header->resizeSection(KeptColumn, wide(tr("saved here")));
  header->resizeSection(NumberColumn, wide(tr("Version")));
  new NameColumn(table_, header, WhatColumn, {{NumberColumn}, {KeptColumn}, {WhenColumn, 60}});
  changes_->setAccessibleName(tr("What the two versions differ in"));
  changes_->setWordWrap(true);
  changes_->setToolTip(tr("Click one to see it on the map"));
  for (QLabel* label : {about_, more_, status_, trouble_}) label->setContentsMargins(8, 4, 8, 4);

  auto* const list = new QWidget(this);
  list->setLayout(
      columnOf({rowOf({{map_, 1}}, 4, QMargins(6, 4, 6, 4)), status_, {table_, 1}}, 0, QMargins()));
  auto* const differences = new QWidget(this);
  differences->setLayout(columnOf(
      {rowOf({{against_, 1}}, 4, QMargins(6, 4, 6, 0)), about_, {changes_, 1}, more_}, 0, QMargins()));
  auto* const split = new QSplitter(Qt::Vertical, this);
  split->addWidget(list);
  split->addWidget(differences);
  split->setChildrenCollapsible(false);
  auto* const whole = new QWidget(this);
  auto* const column = columnOf({trouble_, {split, 1}}, 0, QMargins());
  column->addLayout(rowOf({save_as_, LayoutItem::rest(), restore_}, 6, QMargins(8, 4, 8, 4)));
  whole->setLayout(column);
  whole->setMinimumWidth(240);
  setWidget(whole);

  connect(map_, &QComboBox::activated, this, [this](int index) {
    wanted_ = map_->itemData(index).value<history::MapName>();
    fillTable();
  });
  connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
    if (!filling_) compare();
  });
  connect(against_, &QComboBox::activated, this, &OverlayHistoryDock::compare);
  const auto go_to = [this](const QListWidgetItem* item) {
    geometry::WorldRect area;
    for (const OverlayMark& mark : told_[std::size_t(changes_->row(item))].marks) {
      for (const Eigen::Vector2d& point : mark.points) area.extend(point);
    }
    if (!area.empty()) Q_EMIT areaWanted(area);
  };
  connect(changes_, &QListWidget::itemClicked, this, go_to);
  connect(changes_, &QListWidget::itemActivated, this, go_to);
  connect(restore_, &QPushButton::clicked, this, [this] {
    fetch([this](const KeptVersion& version, std::string text) {
      const auto document = OverlayDocument::read(std::move(text));
      if (!document) return say(sentences::sentenceOf(document.error()));
      Q_EMIT restoreVersionWanted(*document, called(version));
    });
  });
  connect(save_as_, &QPushButton::clicked, this, [this] {
    fetch([this](const KeptVersion& version, std::string text) {
      const QString name = words::plainName(version.map.name.empty() ? version.map.id : version.map.name)
                               .replace(QLatin1Char('/'), QLatin1Char('_')) +
                           QDateTime::fromMSecsSinceEpoch(qint64(version.kept_s * 1000))
                               .toString(QStringLiteral("-yyyyMMdd-HHmmss"));
      Q_EMIT saveAsWanted(name + QStringLiteral(".geojson"), text);
    });
  });
  connect(history_, &OverlayHistory::kept, this, [this] {
    if (isVisible()) lookAnew();
  });
  connect(history_, &OverlayHistory::troubleChanged, this, &OverlayHistoryDock::refresh);
  refresh();
}

void OverlayHistoryDock::showEvent(QShowEvent* event) {
  QDockWidget::showEvent(event);
  lookAnew();
}

void OverlayHistoryDock::hideEvent(QHideEvent* event) {
  QDockWidget::hideEvent(event);
  marks_->show({});
}

void OverlayHistoryDock::openChanged() {
  if (!isVisible()) return;
  if (const auto open = open_ ? open_() : std::nullopt; open && (!wanted_ || *wanted_ != open->map)) {
    const bool other = !wanted_ || !history::isSameMap(*wanted_, open->map);
    if (other) return showMap(open->map);
  }
  refresh();
}

void OverlayHistoryDock::showMap(const history::MapName& map) {
  wanted_ = map;
  if (!read_) return lookAnew();
  fillMaps();
  fillTable();
}

void OverlayHistoryDock::lookAnew() {
  history_->list([this, asked = ++listed_](tl::expected<std::vector<KeptVersion>, Fault> versions) {
    if (asked != listed_) return;
    read_ = true;
    if (!versions) {
      onVersions({});
      return say(sentences::sentenceOf(versions.error()));
    }
    onVersions(std::move(*versions));
  });
}

void OverlayHistoryDock::onVersions(std::vector<KeptVersion> versions) {
  const auto numbers = [](const std::vector<KeptVersion>& of) {
    std::vector<std::int64_t> all;
    for (const KeptVersion& version : of) all.push_back(version.number);
    return all;
  };
  const bool same = numbers(all_) == numbers(versions);
  all_ = std::move(versions);
  if (!wanted_) {
    const auto open = open_ ? open_() : std::nullopt;
    if (open) wanted_ = open->map;
  }
  fillMaps();
  if (!same || shown_.empty()) fillTable();
}

void OverlayHistoryDock::fillMaps() {
  std::vector<history::MapName> maps;
  for (const KeptVersion& version : all_) {
    const bool known = std::any_of(maps.begin(), maps.end(), [&](const history::MapName& map) {
      return map.robot == version.map.robot && map.uid == version.map.uid;
    });
    if (!known) maps.push_back(version.map);
  }
  const auto at = [&] {
    return std::find_if(maps.begin(), maps.end(), [&](const history::MapName& map) {
      return map.robot == wanted_->robot && map.uid == wanted_->uid;
    });
  };
  if (!wanted_ && !maps.empty()) wanted_ = maps.front();
  if (wanted_ && at() == maps.end()) maps.insert(maps.begin(), *wanted_);
  map_->clear();
  for (const history::MapName& map : maps) {
    map_->addItem(mapText(map), QVariant::fromValue(map));
    map_->setItemData(map_->count() - 1, plainToolTip(mapText(map)), Qt::ToolTipRole);
  }
  map_->setEnabled(maps.size() > 1);
  if (wanted_) map_->setCurrentIndex(int(at() - maps.begin()));
}

void OverlayHistoryDock::fillTable() {
  std::int64_t selected = 0;
  if (const auto rows = rowsSelected(); rows.size() == 1) selected = shown_[rows.front()].number;
  filling_ = true;
  ++filled_;
  shown_.clear();
  for (const KeptVersion& version : all_) {
    if (wanted_ && version.map.robot == wanted_->robot && version.map.uid == wanted_->uid)
      shown_.push_back(version);
  }
  table_->clearContents();
  table_->setRowCount(int(shown_.size()));
  for (std::size_t row = 0; row < shown_.size(); ++row) {
    const KeptVersion& version = shown_[row];
    const auto put = [&](Column column, const QString& text) {
      auto* const item = new QTableWidgetItem(text);
      item->setToolTip(plainToolTip(text));
      table_->setItem(int(row), column, item);
    };
    put(WhenColumn, timeText(version.kept_s));
    put(KeptColumn, version.origin == history::Origin::Saved ? tr("saved here") : tr("read"));
    put(NumberColumn, version.version ? QString::number(*version.version) : QStringLiteral("–"));
    put(WhatColumn, QString());
  }
  filling_ = false;
  const auto again = std::find_if(shown_.begin(), shown_.end(),
                                  [&](const KeptVersion& version) { return version.number == selected; });
  table_->clearSelection();
  if (again != shown_.end()) {
    table_->selectRow(int(again - shown_.begin()));
  } else {
    compare();
  }
  say(shown_.empty()
          ? tr("No version of these overlays is kept here yet. Each one that is read or saved will be.")
          : QString());
  summarize(0);
}

/// Some rows after the other: what each changed against the one before it.
void OverlayHistoryDock::summarize(std::size_t from) {
  if (from >= shown_.size()) return;
  std::vector<std::int64_t> numbers;
  for (std::size_t i = from; i < std::min(from + kAtOnce + 1, shown_.size()); ++i)
    numbers.push_back(shown_[i].number);
  const bool first_is_last = from + kAtOnce >= shown_.size();
  history_->ask([this, numbers, first_is_last, from,
                 asked = filled_](tl::expected<history::VersionStore, Fault> store) -> OverlayHistory::Done {
    std::vector<tl::expected<OverlayDocument, Fault>> read;
    for (const std::int64_t number : numbers) read.push_back(versionIn(store, number));
    QStringList sentences;
    for (std::size_t i = 0; i + (first_is_last ? 0 : 1) < read.size(); ++i) {
      if (!read[i]) {
        sentences << tr("It cannot be read. %1").arg(sentences::sentenceOf(read[i].error()));
      } else if (i + 1 == read.size()) {
        sentences
            << tr("First version stored here: %1").arg(featuresText(qsizetype(read[i]->features().size())));
      } else if (!read[i + 1]) {
        sentences << tr("The version before it cannot be read.");
      } else {
        sentences << summaryOf(*read[i + 1], *read[i]);
      }
    }
    return [this, sentences, from, asked] {
      if (asked != filled_) return;
      for (qsizetype i = 0; i < sentences.size() && int(from) + int(i) < table_->rowCount(); ++i) {
        QTableWidgetItem* const item = table_->item(int(from) + int(i), WhatColumn);
        item->setText(sentences[i]);
        item->setToolTip(plainToolTip(sentences[i]));
      }
      summarize(from + kAtOnce);
    };
  });
}

std::vector<std::size_t> OverlayHistoryDock::rowsSelected() const {
  std::vector<std::size_t> rows;
  for (const QModelIndex& index : table_->selectionModel()->selectedRows())
    rows.push_back(std::size_t(index.row()));
  std::sort(rows.begin(), rows.end());
  std::erase_if(rows, [this](std::size_t row) { return row >= shown_.size(); });
  return rows;
}

QString OverlayHistoryDock::called(const KeptVersion& version) const {
  const QString when = timeText(version.kept_s);
  return version.version ? tr("version %1 of %2").arg(*version.version).arg(when) : when;
}

void OverlayHistoryDock::compare() {
  const quint64 asked = ++compared_;
  const auto rows = rowsSelected();
  refresh();
  if (rows.empty() || rows.size() > 2) return showCompared({}, QString());
  const KeptVersion& newer = shown_[rows.front()];
  std::optional<KeptVersion> older;
  std::optional<OverlayDocument> here;
  if (rows.size() == 2) {
    older = shown_[rows.back()];
  } else if (against_->currentIndex() == 1) {
    if (const auto open = open_ ? open_() : std::nullopt) here = open->document();
    if (!here) return showCompared({}, tr("No overlays are open."));
  } else if (rows.front() + 1 < shown_.size()) {
    older = shown_[rows.front() + 1];
  }
  if (!older && !here) return showCompared({}, tr("There is no version before it."));
  const QString about = here ? tr("What bringing back %1 changes:").arg(called(newer))
                             : tr("From %1 to %2:").arg(called(*older), called(newer));
  history_->ask([this, asked, about, here, number = newer.number, before = older ? older->number : 0](
                    tl::expected<history::VersionStore, Fault> store) -> OverlayHistory::Done {
    const auto after = versionIn(store, number);
    const auto from = here ? tl::expected<OverlayDocument, Fault>(*here) : versionIn(store, before);
    if (!after || !from) {
      const QString why = sentences::sentenceOf(after ? from.error() : after.error());
      return [this, asked, why] {
        if (asked == compared_) showCompared({}, why);
      };
    }
    std::vector<Told> told;
    for (const overlays::OverlayChange& change : overlays::changesBetween(*from, *after))
      told.push_back({change.kind, changeText(change, *from, *after), marksOf(change, *from, *after)});
    return [this, asked, about, told = std::move(told)] {
      if (asked == compared_) showCompared(told, told.empty() ? tr("Nothing differs.") : about);
    };
  });
}

void OverlayHistoryDock::showCompared(std::vector<Told> changes, const QString& about) {
  told_ = std::move(changes);
  changes_->clear();
  std::vector<OverlayMark> marks;
  qsizetype unmarked = 0;
  for (std::size_t i = 0; i < told_.size(); ++i) {
    if (i < kMostListed)
      changes_->addItem(new QListWidgetItem(markSample(told_[i].kind, scene_->theme()), told_[i].sentence));
    if (marks.size() < kMostMarks) {
      marks.insert(marks.end(), told_[i].marks.begin(), told_[i].marks.end());
    } else if (!told_[i].marks.empty()) {
      ++unmarked;
    }
  }
  const auto unlisted = qsizetype(told_.size() - std::min(told_.size(), kMostListed));
  QStringList more;
  if (unlisted > 0)
    more << sentences::counted(tr("%1 more are not listed.", nullptr, sentences::formOf(unlisted)), unlisted);
  if (unmarked > 0)
    more << sentences::counted(tr("%1 are not marked on the map.", nullptr, sentences::formOf(unmarked)),
                               unmarked);
  more_->setText(words::paragraph(more));
  more_->setVisible(!more.isEmpty());
  about_->setText(about);
  about_->setVisible(!about.isEmpty());
  marks_->show(isVisible() ? std::move(marks) : std::vector<OverlayMark>());
}

void OverlayHistoryDock::fetch(std::function<void(const KeptVersion& version, std::string text)> then) {
  const auto rows = rowsSelected();
  if (rows.size() != 1) return;
  history_->ask([this, version = shown_[rows.front()], then = std::move(then)](
                    tl::expected<history::VersionStore, Fault> store) -> OverlayHistory::Done {
    auto text = store ? store->text(version.number)
                      : tl::expected<std::string, Fault>(tl::make_unexpected(store.error()));
    return [this, version, then, text = std::move(text)] {
      if (!text) return say(sentences::sentenceOf(text.error()));
      then(version, *text);
    };
  });
}

QString OverlayHistoryDock::notBackReason() const {
  const auto rows = rowsSelected();
  if (rows.size() != 1) return tr("Select one version first");
  const auto open = open_ ? open_() : std::nullopt;
  if (!open) return tr("Open the overlays of this map first; without its robot, save the version as a file");
  if (!history::isSameMap(open->map, shown_[rows.front()].map)) return tr("Another map is open");
  return open->editable ? QString() : tr("They cannot be edited at present");
}

void OverlayHistoryDock::refresh() {
  const QString unavailable_reason = notBackReason();
  restore_->setEnabled(unavailable_reason.isEmpty());
  restore_->setToolTip(unavailable_reason.isEmpty()
                           ? tr("Makes the open overlays what they were then: one step that can be undone. "
                                "Nothing is sent before the review")
                           : unavailable_reason);
  const std::size_t selected = rowsSelected().size();
  save_as_->setEnabled(selected == 1);
  against_->setEnabled(selected < 2);
  const Fault& trouble = history_->trouble();
  trouble_->setVisible(trouble.any());
  setTextColor(*trouble_, appColors().error_text);
  trouble_->setText(trouble.any()
                        ? tr("The newest version is not kept here. %1").arg(sentences::sentenceOf(trouble))
                        : QString());
}

void OverlayHistoryDock::say(const QString& sentence) {
  status_->setText(sentence);
  status_->setVisible(!sentence.isEmpty());
}

QString OverlayHistoryDock::statusShown() const { return status_->isHidden() ? QString() : status_->text(); }
QString OverlayHistoryDock::moreShown() const { return more_->isHidden() ? QString() : more_->text(); }
QString OverlayHistoryDock::troubleShown() const {
  return trouble_->isHidden() ? QString() : trouble_->text();
}

}  // namespace mapwright::ui

#include "moc_overlay_history_dock.cpp"
