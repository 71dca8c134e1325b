#include "ui/kit/name_column.h"

#include <algorithm>
#include <numeric>

#include <QAbstractItemView>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>

namespace mapwright::ui {

namespace {
constexpr int kLettersKept = 32;    // of names: as long as columns can go instead
constexpr int kRowsLookedAt = 200;  // for their widths
constexpr int kSoonMs = 50;
}  // namespace

NameColumn::NameColumn(QAbstractItemView* view, QHeaderView* header, int column,
                       std::vector<ColumnBeside> shrinking)
    : QObject(view), view_(view), header_(header), column_(column), beside_(std::move(shrinking)) {
  header_->setStretchLastSection(false);
  header_->setCascadingSectionResizes(false);
  header_->setResizeContentsPrecision(kRowsLookedAt);
  header_->setMinimumSectionSize(std::min(header_->minimumSectionSize(), 22));
  header_->setSectionResizeMode(column_, QHeaderView::Stretch);
  for (const ColumnBeside& beside : beside_) full_px_.push_back(header_->sectionSize(beside.column));
  gone_.resize(beside_.size());
  soon_.setSingleShot(true);
  soon_.setInterval(kSoonMs);
  connect(&soon_, &QTimer::timeout, this, &NameColumn::fit);
  connect(header_, &QHeaderView::sectionResized, this, [this](int resized, int, int px) {
    if (fitting_ || !(QGuiApplication::mouseButtons() & Qt::LeftButton)) return;
    for (std::size_t i = 0; i < beside_.size(); ++i)
      if (beside_[i].column == resized) full_px_[i] = px;
  });
  view_->viewport()->installEventFilter(this);
  watchModel();
}

void NameColumn::watchModel() {
  QAbstractItemModel* const model = view_->model();
  const auto later = [this] {
    if (view_->isVisible() && !soon_.isActive()) soon_.start();
  };
  connect(model, &QAbstractItemModel::rowsInserted, this, later);
  connect(model, &QAbstractItemModel::modelReset, this, later);
  connect(
      model, &QAbstractItemModel::dataChanged, this,
      [this, later](const QModelIndex& first, const QModelIndex& last) {
        const auto changed = [&](int column) { return first.column() <= column && column <= last.column(); };
        if (changed(column_) || std::any_of(beside_.begin(), beside_.end(), [&](const ColumnBeside& beside) {
              return beside.least_px > 0 && changed(beside.column);
            }))
          later();
      });
}

bool NameColumn::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Resize:
      fit();
      break;
    case QEvent::Show:
    case QEvent::FontChange:
    case QEvent::StyleChange:
      soon_.start();
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

int NameColumn::contentsOf(int column) const {
  return std::max(view_->sizeHintForColumn(column),
                  header_->isHidden() ? 0 : header_->sectionSizeHint(column));
}

int NameColumn::wanted() const { return std::max(view_->sizeHintForColumn(column_), 0) + 1; }

void NameColumn::fit() {
  soon_.stop();
  if (fitting_ || view_->model()->columnCount() == 0) return;
  const int room = view_->viewport()->width();
  const int names = std::max(wanted(), header_->isHidden() ? 0 : header_->sectionSizeHint(column_));
  std::vector<int> widths(beside_.size());
  std::vector<bool> shown(beside_.size());
  for (std::size_t i = 0; i < beside_.size(); ++i) {
    shown[i] = gone_[i] || !header_->isSectionHidden(beside_[i].column);
    widths[i] = shown[i] ? full_px_[i] : 0;
  }
  const auto missing = [&](int wanted) {
    return wanted + std::accumulate(widths.begin(), widths.end(), 0) - room;
  };
  const auto fit_texts = [&] {
    for (std::size_t i = 0; i < beside_.size(); ++i) {
      if (!shown[i] || beside_[i].least_px == 0) continue;
      // What is hidden is not measured.
      const int contents = std::max(contentsOf(beside_[i].column), beside_[i].least_px),
                lack = missing(names);
      widths[i] +=
          lack > 0 ? -std::clamp(widths[i] - contents, 0, lack) : std::clamp(contents - widths[i], 0, -lack);
    }
  };
  fit_texts();
  const int kept = std::min(names, kLettersKept * view_->fontMetrics().averageCharWidth());
  for (std::size_t i = 0; i < beside_.size() && missing(kept) > 0; ++i) {
    if (!shown[i] || !beside_[i].may_go) continue;
    shown[i] = false;
    widths[i] = 0;
  }
  fit_texts();  // in the room of what has gone
  for (std::size_t i = 0; i < beside_.size() && missing(kept) > 0; ++i) {
    if (shown[i] && beside_[i].least_px > 0)
      widths[i] -= std::clamp(widths[i] - beside_[i].least_px, 0, missing(kept));
  }
  fitting_ = true;
  for (std::size_t i = 0; i < beside_.size(); ++i) {
    const bool wants = gone_[i] || !header_->isSectionHidden(beside_[i].column);
    if (!wants) continue;  // hidden by someone else
    if (gone_[i] && shown[i]) soon_.start();
    gone_[i] = !shown[i];
    if (header_->isSectionHidden(beside_[i].column) == shown[i])
      header_->setSectionHidden(beside_[i].column, !shown[i]);
    if (shown[i] && header_->sectionSize(beside_[i].column) != widths[i])
      header_->resizeSection(beside_[i].column, widths[i]);
  }
  fitting_ = false;
}

}  // namespace mapwright::ui

#include "moc_name_column.cpp"
