#include "ui/maps/maps_dock.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "sentences/absence_sentence.h"
#include "sentences/failure_sentence.h"
#include "sentences/plural.h"
#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/status_text.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/ui_colors.h"
#include "ui/maps/map_row_delegate.h"

namespace mapwright::window {

MapsDock::MapsDock(QWidget* parent)
    : QDockWidget(tr("Maps"), parent),
      model_(new MapsModel(this)),
      search_(new QLineEdit(this)),
      refresh_(new QToolButton(this)),
      list_(new QuietListView(this)),
      empty_(new QLabel(this)),
      status_(new QLabel(this)),
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
  for (QLabel* label : {empty_, status_}) {
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setContentsMargins(8, 4, 8, 4);
  }
  empty_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  retry_->setObjectName(QStringLiteral("compact"));

  auto* body = new QWidget(this);
  auto* top = new QHBoxLayout;
  top->setContentsMargins(6, 6, 6, 4);
  top->setSpacing(4);
  top->addWidget(search_, 1);
  top->addWidget(refresh_);
  auto* bottom = new QHBoxLayout;
  bottom->setContentsMargins(0, 0, 6, 2);
  bottom->addWidget(status_, 1);
  bottom->addWidget(retry_);
  auto* column = new QVBoxLayout(body);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(top);
  column->addWidget(empty_);
  column->addWidget(list_, 1);
  column->addLayout(bottom);
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
  connect(list_, &QListView::doubleClicked, this, [this](const QModelIndex& index) {
    if (const auto key = model_->key(index)) Q_EMIT openWanted(*key);
  });
  connect(list_, &QListView::customContextMenuRequested, this, &MapsDock::showMenu);
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
    session_->catalogue().disconnect(this);
    session_->wholeMap().disconnect(this);
  }
  session_ = session;
  search_->clear();
  model_->setSession(session);
  if (session) {
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
  const QString why_not =
      session_ && !offered
          ? plainToolTip(sentences::whyAbsent(robot::Capability::Catalogue,
                                              session_->robot().whyNot(robot::Capability::Catalogue)))
          : QString();
  search_->setToolTip(why_not);
  refresh_->setToolTip(why_not.isEmpty() ? tr("Ask the robot for its maps again") : why_not);
  empty_->setText(emptyText());
  empty_->setVisible(!empty_->text().isEmpty());
  retry_->setVisible(!error.isEmpty() && !loading);
  const UiColors colors = appColors();
  QPalette palette = status_->palette();
  palette.setColor(QPalette::WindowText, error.isEmpty() ? colors.secondary_text : colors.error_text);
  status_->setPalette(palette);
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
    return sentences::whyAbsent(robot::Capability::Catalogue,
                                session_->robot().whyNot(robot::Capability::Catalogue));
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
  menu.addAction(themedIcon(QStringLiteral("export")), tr("Export…"), this,
                 [this, key] { Q_EMIT exportWanted(*key); });
  Q_EMIT menuOpening(&menu, *key);
  if (!key->id.empty()) {
    menu.addSeparator();
    menu.addAction(themedIcon(QStringLiteral("copy")), tr("Copy id"), this, [this, key] {
      const QString id = QString::fromStdString(key->id);
      Q_EMIT copyWanted(id, tr("Copied %1").arg(id.left(80)));
    });
  }
  menu.exec(list_->viewport()->mapToGlobal(at));
}

bool MapsDock::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (watched == list_ && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
      if (const auto chosen = model_->key(list_->currentIndex())) Q_EMIT openWanted(*chosen);
      return true;
    }
    if (watched == search_ && key == Qt::Key_Down) {
      list_->setFocus();
      return true;
    }
  }
  return QDockWidget::eventFilter(watched, event);
}

}  // namespace mapwright::window

#include "moc_maps_dock.cpp"
