#include "ui/maps/maps_dock.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QToolButton>

#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/plural.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::ui {
namespace {

constexpr int kMapRowPx = 56, kMapSectionPx = 24, kMapPad = 4, kSubmapsRowPx = 26, kSmallIconPx = 16;
// Names from robots are left-aligned in any script, so that all rows begin at the same edge.
constexpr int kLeft = int(Qt::AlignLeft) | int(Qt::AlignAbsolute) | int(Qt::AlignVCenter);

MapsModel::RowKind kindOf(const QModelIndex& index) {
  return MapsModel::RowKind(index.data(MapsModel::KindRole).toInt());
}

/// Paints a row of the catalogue: thumbnail, name, badges and details.
class MapRowDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  void paintSection(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
  void paintThumbnail(QPainter* painter, const QRect& box, const QModelIndex& index) const;
  void paintSubmaps(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
};

QSize MapRowDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const {
  switch (kindOf(index)) {
    case MapsModel::RowKind::Section:
      return {100, kMapSectionPx};
    case MapsModel::RowKind::Live:
    case MapsModel::RowKind::Fetched:
      return {100, 40};
    case MapsModel::RowKind::Submaps:
      return {100, kSubmapsRowPx};
    case MapsModel::RowKind::Map:
      break;
  }
  return {100, kMapRowPx};
}

void MapRowDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
  if (kindOf(index) == MapsModel::RowKind::Section) {
    paintSection(painter, option, index);
    return;
  }
  QStyleOptionViewItem row = option;
  initStyleOption(&row, index);
  row.text.clear();
  const QStyle* style = row.widget ? row.widget->style() : QApplication::style();
  style->drawControl(QStyle::CE_ItemViewItem, &row, painter, row.widget);
  paintRowState(painter, option.rect, option.state.testFlag(QStyle::State_Selected),
                option.state.testFlag(QStyle::State_HasFocus));
  if (kindOf(index) == MapsModel::RowKind::Submaps) return paintSubmaps(painter, option, index);
  const UiColors colors = appColors();
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const int edge = MapsModel::kThumbnailPx;
  const QRect box(option.rect.left() + kMapPad, option.rect.top() + (option.rect.height() - edge) / 2, edge,
                  edge);
  paintThumbnail(painter, box, index);
  QRect text = option.rect.adjusted(2 * kMapPad + edge + 2, 4, -kMapPad, -4);
  const QFontMetrics metrics(option.font);

  // The badges are at the right end of the first line; the name takes the rest.
  const QStringList badges = index.data(MapsModel::BadgesRole).toStringList();
  QFont small = option.font;
  small.setPointSizeF(small.pointSizeF() * 0.8);
  small.setWeight(QFont::DemiBold);
  const QFontMetrics small_metrics(small);
  const int line = text.height() / 2;
  QRect first(text.left(), text.top(), text.width(), line);
  for (auto it = badges.rbegin(); it != badges.rend(); ++it) {
    const bool current = std::next(it) == badges.rend() && index.data(MapsModel::CurrentRole).toBool();
    const QColor color = current ? colors.ok_text : colors.accent_text;
    const int width = small_metrics.horizontalAdvance(*it) + 8;
    const QRectF badge(first.right() - width + 1, first.center().y() - 7, width, 16);
    QColor fill = color;
    fill.setAlpha(26);
    painter->setPen(Qt::NoPen);
    painter->setBrush(fill);
    painter->drawRoundedRect(badge, 4, 4);
    painter->setPen(color);
    painter->setFont(small);
    painter->drawText(badge, Qt::AlignCenter, *it);
    first.setRight(int(badge.left()) - 4);
  }
  const bool nameless =
      index.data(MapsModel::NamelessRole).toBool() && kindOf(index) == MapsModel::RowKind::Map;
  painter->setFont(option.font);
  painter->setPen(nameless ? colors.secondary_text : colors.text);
  painter->drawText(first, kLeft | Qt::TextSingleLine,
                    metrics.elidedText(index.data().toString(), Qt::ElideMiddle, first.width()));
  QFont second = option.font;
  second.setPointSizeF(second.pointSizeF() * 0.88);
  painter->setFont(second);
  painter->setPen(colors.secondary_text);
  const QRect below(text.left(), text.top() + line, text.width(), text.height() - line);
  painter->drawText(below, kLeft | Qt::TextSingleLine,
                    QFontMetrics(second).elidedText(index.data(MapsModel::DetailRole).toString(),
                                                    Qt::ElideRight, below.width()));
  painter->restore();
}

void MapRowDelegate::paintSection(QPainter* painter, const QStyleOptionViewItem& option,
                                  const QModelIndex& index) const {
  const UiColors colors = appColors();
  painter->save();
  QFont font = option.font;
  font.setPointSizeF(font.pointSizeF() * 0.88);
  font.setWeight(QFont::DemiBold);
  painter->setFont(font);
  painter->setPen(colors.secondary_text);
  painter->drawText(option.rect.adjusted(8, 4, -8, 0), kLeft, index.data().toString());
  painter->restore();
}

/// Smaller than its map, its text below the map's.
void MapRowDelegate::paintSubmaps(QPainter* painter, const QStyleOptionViewItem& option,
                                  const QModelIndex& index) const {
  const UiColors colors = appColors();
  const QRect text = option.rect.adjusted(2 * kMapPad + MapsModel::kThumbnailPx + 2, 0, -kMapPad, 0);
  QFont font = option.font;
  font.setPointSizeF(font.pointSizeF() * 0.88);
  const QFontMetrics metrics(font);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  paintIcon(painter,
            QRectF(text.left() - kMapPad - 2 - kSmallIconPx, text.center().y() + 0.5 - kSmallIconPx / 2.0,
                   kSmallIconPx, kSmallIconPx),
            QStringLiteral("submaps"), colors.secondary_text);
  painter->setFont(font);
  painter->setPen(colors.text);
  const QString title = index.data().toString() + QLatin1Char(' ');
  painter->drawText(text, kLeft | Qt::TextSingleLine,
                    metrics.elidedText(title, Qt::ElideRight, text.width()));
  const QRect rest = text.adjusted(metrics.horizontalAdvance(title + QLatin1Char(' ')), 0, 0, 0);
  painter->setPen(colors.secondary_text);
  if (rest.width() > 0)
    painter->drawText(
        rest, kLeft | Qt::TextSingleLine,
        metrics.elidedText(index.data(MapsModel::DetailRole).toString(), Qt::ElideRight, rest.width()));
  painter->restore();
}

void MapRowDelegate::paintThumbnail(QPainter* painter, const QRect& box, const QModelIndex& index) const {
  const UiColors colors = appColors();
  if (kindOf(index) == MapsModel::RowKind::Live) {
    paintIcon(painter, QRectF(box).adjusted(12, 12, -12, -12), QStringLiteral("robot"),
              colors.secondary_text);
    return;
  }
  if (kindOf(index) == MapsModel::RowKind::Fetched) {
    paintIcon(painter, QRectF(box).adjusted(12, 12, -12, -12), QStringLiteral("rectangle"),
              colors.secondary_text);
    return;
  }
  painter->setPen(colors.border);
  painter->setBrush(colors.window);
  painter->drawRoundedRect(QRectF(box).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
  const QPixmap picture = index.data(MapsModel::ThumbnailRole).value<QPixmap>();
  if (picture.isNull()) {
    paintIcon(painter, QRectF(box).adjusted(12, 12, -12, -12), QStringLiteral("map"), colors.neutral);
    return;
  }
  const QSizeF size = QSizeF(picture.size()) / picture.devicePixelRatio();
  painter->drawPixmap(
      QPointF(box.center().x() + 0.5 - size.width() / 2, box.center().y() + 0.5 - size.height() / 2),
      picture);
}

}  // namespace

MapsDock::MapsDock(QWidget* parent)
    : QDockWidget(tr("Maps"), parent),
      model_(new MapsModel(this)),
      search_(new QLineEdit(this)),
      refresh_(new QToolButton(this)),
      list_(new QuietListView(this)),
      empty_(wrappedLabel({}, this)),
      status_(wrappedLabel({}, this)),
      retry_(new QPushButton(tr("Retry"), this)) {
  setObjectName(QStringLiteral("maps"));
  search_->setPlaceholderText(tr("Search maps"));
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(tr("Search maps"));
  refresh_->setIcon(themedIcon(QStringLiteral("retry")));
  refresh_->setIconSize({16, 16});
  refresh_->setAccessibleName(tr("Refresh the list of maps"));
  list_->setModel(model_);
  list_->setItemDelegate(new MapRowDelegate(list_));
  list_->setUniformItemSizes(false);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->setContextMenuPolicy(Qt::CustomContextMenu);
  list_->setAccessibleName(tr("Maps"));
  list_->setMinimumWidth(180);
  for (QLabel* label : {empty_, status_}) label->setContentsMargins(8, 4, 8, 4);
  empty_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  retry_->setObjectName(QStringLiteral("compact"));

  auto* body = new QWidget(this);
  body->setLayout(columnOf({rowOf({{search_, 1}, refresh_}, 4, QMargins(6, 6, 6, 4)),
                            empty_,
                            {list_, 1},
                            rowOf({{status_, 1}, retry_}, -1, QMargins(0, 0, 6, 2))},
                           0, QMargins()));
  setWidget(body);

  connect(search_, &QLineEdit::textChanged, this, [this](const QString& text) {
    model_->setFilter(text);
    refresh();
  });
  const auto ask = [this] {
    if (session_) session_->catalogue().refresh();
  };
  connect(refresh_, &QToolButton::clicked, this, ask);
  connect(retry_, &QPushButton::clicked, this, ask);
  connect(list_, &QListView::doubleClicked, this, &MapsDock::activate);
  connect(list_, &QListView::customContextMenuRequested, this, &MapsDock::showMenu);
  connect(this, &QDockWidget::visibilityChanged, this, [this](bool visible) {
    if (!visible && session_) session_->catalogue().releaseThumbnails();
  });
  list_->installEventFilter(this);
  search_->installEventFilter(this);
  refresh();
}

MapsDock::~MapsDock() {
  list_->removeEventFilter(this);
  search_->removeEventFilter(this);
}

void MapsDock::setSession(session::Session* session) {
  if (session_) {
    session_->robot().disconnect(this);
    session_->catalogue().disconnect(this);
    session_->wholeMap().disconnect(this);
  }
  session_ = session;
  search_->clear();
  model_->setSession(session);
  if (session) {
    connect(&session->robot(), &robot::Robot::capabilitiesChanged, this, &MapsDock::refresh);
    connect(&session->catalogue(), &session::Catalogue::changed, this, &MapsDock::refresh);
    connect(&session->catalogue(), &session::Catalogue::thumbnailArrived, model_,
            &MapsModel::thumbnailArrived);
    connect(&session->wholeMap(), &session::MapSlot::changed, this, &MapsDock::refresh);
  }
  refresh();
}

void MapsDock::refresh() {
  model_->sync();
  const bool offered = session_ && session_->catalogue().offered();
  const bool loading = offered && session_->catalogue().loading();
  const QString error = offered && session_->catalogue().failure()
                            ? QString::fromStdString(sentences::sentenceOf(*session_->catalogue().failure()))
                            : QString();
  search_->setEnabled(offered);
  refresh_->setEnabled(offered && !loading);
  const QString unavailable_reason =
      session_ && !offered ? plainToolTip(sentences::absenceReason(
                                 robot::Capability::Catalogue,
                                 session_->robot().unavailableReason(robot::Capability::Catalogue)))
                           : QString();
  search_->setToolTip(unavailable_reason);
  refresh_->setToolTip(unavailable_reason.isEmpty() ? tr("Ask the robot for its maps again")
                                                    : unavailable_reason);
  empty_->setText(emptyText());
  empty_->setVisible(!empty_->text().isEmpty());
  retry_->setVisible(!error.isEmpty() && !loading);
  setTextColor(*status_, error.isEmpty() ? appColors().secondary_text : appColors().error_text);
  QString text;
  if (loading) {
    text = tr("Asking the robot…");
  } else if (!error.isEmpty()) {
    text = error;
  } else if (offered && session_->catalogue().asOf()) {
    text = tr("%1, as of %2")
               .arg(sentences::counted(tr("%1 maps", nullptr, model_->maps()), model_->maps()),
                    session_->catalogue().asOf()->toString(QStringLiteral("HH:mm:ss")));
  }
  status_->setText(text);
  status_->setVisible(!text.isEmpty());
}

QString MapsDock::emptyText() const {
  if (!session_) return tr("Connect to a robot to see its maps, or open a map file (Ctrl+Shift+O).");
  if (!session_->catalogue().offered()) {
    return sentences::absenceReason(robot::Capability::Catalogue,
                                    session_->robot().unavailableReason(robot::Capability::Catalogue));
  }
  if (session_->catalogue().loading() || session_->catalogue().failure()) return {};
  if (model_->maps() == 0) {
    return session_->catalogue().asOf() ? tr("The robot has no stored maps.")
                                        : tr("The list appears as soon as the robot is connected.");
  }
  return model_->found() == 0 ? tr("No map matches the search.") : QString();
}

QString MapsDock::statusShown() const { return status_->isHidden() ? QString() : status_->text(); }
QString MapsDock::emptyShown() const { return empty_->isHidden() ? QString() : empty_->text(); }

void MapsDock::activate(const QModelIndex& index) {
  const auto key = model_->key(index);
  if (!key) return;
  if (model_->isSubmaps(index)) {
    Q_EMIT submapsWanted(*key);
  } else {
    Q_EMIT openWanted(*key);
  }
}

void MapsDock::showMenu(const QPoint& at) {
  const auto key = model_->key(list_->indexAt(at));
  if (!key || !session_) return;
  QMenu menu(this);
  menu.setToolTipsVisible(true);
  if (model_->isFetched(list_->indexAt(at))) {
    menu.addAction(themedIcon(QStringLiteral("map")), tr("Preview"), this,
                   [this, key] { Q_EMIT openWanted(*key); });
    menu.addAction(themedIcon(QStringLiteral("export")), tr("Export…"), this,
                   [this, key] { Q_EMIT exportWanted(*key); });
    menu.addSeparator();
    QAction* const forget = menu.addAction(themedIcon(QStringLiteral("remove")), tr("Remove"), this,
                                           [this, key] { Q_EMIT forgetWanted(*key); });
    forget->setObjectName(QStringLiteral("forgetFetched"));
    forget->setToolTip(tr("Show the map by regions again. This changes nothing on the robot."));
    menu.exec(list_->viewport()->mapToGlobal(at));
    return;
  }
  QAction* open = menu.addAction(themedIcon(QStringLiteral("map")), tr("Open"), this,
                                 [this, key] { Q_EMIT openWanted(*key); });
  open->setToolTip(tr("Show it here. This loads and changes nothing on the robot."));
  menu.addAction(themedIcon(QStringLiteral("compare")), tr("Compare with the open map"), this,
                 [this, key] { Q_EMIT compareWanted(*key); });
  QAction* const align =
      menu.addAction(tr("Align with the open map"), this, [this, key] { Q_EMIT alignWanted(*key); });
  const session::MapSlot& open_map = session_->wholeMap();
  const bool is_open = open_map.cells() && open_map.shown().key == *key;
  align->setEnabled(session_->counts().shown > 0 || (open_map.cells() && !is_open));
  align->setToolTip(
      tr("Find out where this map lies on the open one, and lay it under it as the reference map"));
  menu.addAction(themedIcon(QStringLiteral("export")), tr("Export…"), this,
                 [this, key] { Q_EMIT exportWanted(*key); });
  Q_EMIT menuOpening(&menu, *key);
  if (!key->id.empty()) {
    menu.addSeparator();
    menu.addAction(themedIcon(QStringLiteral("copy")), tr("Copy id"), this, [this, key] {
      const QString id = QString::fromStdString(key->id);
      Q_EMIT copyWanted(id, tr("Copied %1").arg(plainWords(id, 80)));
    });
  }
  menu.exec(list_->viewport()->mapToGlobal(at));
}

bool MapsDock::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (watched == list_ && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
      activate(list_->currentIndex());
      return true;
    }
    if (watched == search_ && key == Qt::Key_Down) {
      list_->setFocus();
      return true;
    }
  }
  return QDockWidget::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_maps_dock.cpp"
