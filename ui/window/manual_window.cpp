#include "ui/window/manual_window.h"

#include <algorithm>
#include <functional>
#include <utility>

#include <QAbstractTextDocumentLayout>
#include <QFile>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollBar>
#include <QShortcut>
#include <QSplitter>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QToolButton>

#include "sentences/language.h"
#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/ui_colors.h"

static void initManual() { Q_INIT_RESOURCE(manual); }  // not within a namespace

namespace mapwright::ui {

namespace {

/// In reading order; docs/manual.qrc has the same ones, and the package installs them.
constexpr const char* kPages[] = {"docs/getting-started.md", "docs/getting-started.zh-CN.md",
                                  "docs/window.md",          "docs/tasks/waypoints.md",
                                  "docs/tasks/overlays.md",  "docs/tasks/pictures.md",
                                  "docs/tasks/mapping.md",   "docs/tasks/poses.md",
                                  "docs/tasks/replay.md",    "docs/tasks/compare.md",
                                  "docs/tasks/new-map.md",   "docs/tasks/map-quality.md",
                                  "docs/command-line.md",    "docs/json.md",
                                  "docs/files.md",           "docs/troubleshooting.md",
                                  "docs/simulator.md",       "docs/maps-in-ci.md",
                                  "docs/same-bytes.md"};
constexpr int kPageRole = Qt::UserRole, kPositionRole = Qt::UserRole + 1;
constexpr int kMostHits = 200, kMostMarks = 1000, kPicturePx = 720, kMarginPx = 16;

QUrl urlOf(int page) { return QStringLiteral("qrc:/manual/") + QLatin1String(kPages[page]); }

/// That of the language that is spoken, if there is one in it.
int firstPage() {
  const QString ending = QLatin1Char('.') +
                         sentences::spokenLanguage().replace(QLatin1Char('_'), QLatin1Char('-')) +
                         QLatin1String(".md");
  const auto in_language = std::find_if(std::begin(kPages), std::end(kPages), [&](const char* page) {
    return QLatin1String(page).endsWith(ending);
  });
  return in_language == std::end(kPages) ? 0 : int(in_language - std::begin(kPages));
}

QString manualText(int page) {
  QFile file(QLatin1Char(':') + urlOf(page).path());
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// As links name a heading: "mapwright-maps".
QString anchorOf(const QString& heading) {
  static const QRegularExpression odd(QStringLiteral("[^\\w -]"));
  return heading.toLower().remove(odd).replace(QLatin1Char(' '), QLatin1Char('-'));
}

QStringList searchedWords(const QString& typed) { return typed.split(QLatin1Char(' '), Qt::SkipEmptyParts); }

QString excerptOf(const QString& text, const QString& word) {
  const qsizetype from = std::max<qsizetype>(0, text.indexOf(word, 0, Qt::CaseInsensitive) - 24);
  return (from > 0 ? QStringLiteral("…") : QString()) + text.mid(from, 120);
}

/// Finds headings by their links, fits pictures to the window, and tells of links to what it does not have.
class ManualPage : public QTextBrowser {
 public:
  using QTextBrowser::QTextBrowser;
  std::function<void(const QUrl&)> on_missing;

  void goTo(int position) {
    QTextCursor cursor(document());
    cursor.setPosition(position);
    setTextCursor(cursor);
    (void)document()->size();  // lays out all of it, so that the scroll bar reaches there
    verticalScrollBar()->setValue(int(document()->documentLayout()->blockBoundingRect(cursor.block()).top()));
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QTextBrowser::resizeEvent(event);
    const int room_px = std::min(kPicturePx, viewport()->width() - 2 * kMarginPx);
    if (std::exchange(picture_px_, room_px) != room_px) readAgain();
  }
  void changeEvent(QEvent* event) override {
    QTextBrowser::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) readAgain();  // links keep the colour they were read with
  }
  QVariant loadResource(int type, const QUrl& name) override {
    if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, name);
    QImage image(QLatin1Char(':') + name.path());
    const int width = int(picture_px_ * devicePixelRatioF());
    if (image.width() > width) image = image.scaledToWidth(width, Qt::SmoothTransformation);
    image.setDevicePixelRatio(devicePixelRatioF());
    return image;
  }
  void doSetSource(const QUrl& url, QTextDocument::ResourceType type) override {
    if (!QFile::exists(QLatin1Char(':') + url.path())) return on_missing(url);
    QTextCursor whole(document());
    whole.beginEditBlock();  // or every word that is read would be laid out by itself
    QTextBrowser::doSetSource(url, type);
    whole.endEditBlock();
    if (!url.hasFragment()) return;
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
      if (block.blockFormat().headingLevel() > 0 && anchorOf(block.text()) == url.fragment())
        return goTo(block.position());
    }
  }

 private:
  void readAgain() {
    if (source().isEmpty()) return;
    const int at = verticalScrollBar()->value();
    reload();
    verticalScrollBar()->setValue(at);
  }

  int picture_px_ = kPicturePx;
};

}  // namespace

ManualWindow::ManualWindow(QWidget* parent)
    : QDialog(parent),
      search_(new QLineEdit(this)),
      said_(wrappedLabel({}, this)),
      list_(new QListWidget(this)),
      page_(new ManualPage(this)) {
  setWindowTitle(tr("Manual"));
  initManual();
  for (int page = 0; page < int(std::size(kPages)); ++page)
    titles_.push_back(manualText(page).section(QLatin1Char('\n'), 0, 0).remove(QStringLiteral("# ")));

  search_->setPlaceholderText(tr("Search all pages (Ctrl+F)"));
  search_->setClearButtonEnabled(true);
  search_->addAction(themedIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  search_->installEventFilter(this);
  list_->setAccessibleName(tr("Pages of the manual"));
  page_->setAccessibleName(tr("Page of the manual"));
  search_->setAccessibleName(tr("Search the manual"));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  static_cast<ManualPage*>(page_)->on_missing = [this](const QUrl& url) {
    said_->setText(tr("%1 is not in this manual.").arg(url.path().section(QLatin1String("/manual/"), 1)));
    said_->show();
  };
  page_->setOpenExternalLinks(true);
  page_->document()->setDocumentMargin(kMarginPx);
  page_->setFrameShape(QFrame::NoFrame);

  QToolButton* const back = iconButton(QStringLiteral("event-back"), 16, tr("Back (Alt+Left)"), this);
  QToolButton* const forward =
      iconButton(QStringLiteral("event-forward"), 16, tr("Forward (Alt+Right)"), this);
  connect(back, &QToolButton::clicked, page_, &QTextBrowser::backward);
  connect(forward, &QToolButton::clicked, page_, &QTextBrowser::forward);
  connect(page_, &QTextBrowser::historyChanged, this, [this, back, forward] {
    back->setEnabled(page_->isBackwardAvailable());
    forward->setEnabled(page_->isForwardAvailable());
  });
  auto* const left = new QWidget(this);
  left->setLayout(
      columnOf({rowOf({back, forward, {search_, 1}}, 4), said_, {list_, 1}}, 6, QMargins(8, 8, 0, 8)));
  auto* const parts = new QSplitter(this);
  parts->addWidget(left);
  parts->addWidget(page_);
  parts->setStretchFactor(1, 1);
  parts->setSizes({280, 800});
  setLayout(columnOf({{parts, 1}}, 0, QMargins()));
  resize(QSize(1080, 720).boundedTo(screen()->availableSize() * 0.9));

  connect(search_, &QLineEdit::textChanged, this, &ManualWindow::listHits);
  connect(search_, &QLineEdit::returnPressed, this, [this] { open(list_->currentItem()); });
  connect(list_, &QListWidget::itemClicked, this, &ManualWindow::open);
  connect(list_, &QListWidget::itemActivated, this, &ManualWindow::open);
  connect(page_, &QTextBrowser::sourceChanged, this, [this](const QUrl& url) {
    if (search_->text().trimmed().isEmpty()) listPages(url);
    mark();
  });
  auto* const find = new QShortcut(QKeySequence::Find, this);
  connect(find, &QShortcut::activated, search_, [this] {
    search_->setFocus(Qt::ShortcutFocusReason);
    search_->selectAll();
  });
  page_->setSource(urlOf(firstPage()));
  search_->setFocus();
}

void ManualWindow::listPages(const QUrl& open) {
  list_->clear();
  said_->hide();
  for (int page = 0; page < int(titles_.size()); ++page) {
    auto* const item = new QListWidgetItem(titles_[page], list_);
    item->setData(kPageRole, page);
    if (urlOf(page).path() == open.path()) list_->setCurrentItem(item);
  }
}

void ManualWindow::readAll() {
  for (int page = 0; page < int(titles_.size()); ++page) {
    QTextDocument document;
    document.setMarkdown(manualText(page));
    QString heading;
    const QTextTable* table = nullptr;
    int row = 0;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
      if (block.blockFormat().headingLevel() > 0) heading = block.text();
      const QTextTable* const in = QTextCursor(block).currentTable();
      const int in_row = in ? in->cellAt(block.position()).row() : 0;
      if (in && in == table && in_row == row) {
        passages_.back().text += QStringLiteral("  ") + block.text();
      } else if (!block.text().trimmed().isEmpty()) {
        passages_.push_back({page, block.position(), heading, block.text()});
        table = in;
        row = in_row;
      }
    }
  }
}

void ManualWindow::listHits() {
  const QStringList words = searchedWords(search_->text());
  mark();
  if (words.isEmpty()) return listPages(page_->source());
  if (passages_.empty()) readAll();
  std::vector<const Passage*> hits;
  for (const Passage& passage : passages_) {
    if (std::all_of(words.begin(), words.end(),
                    [&](const QString& word) { return passage.text.contains(word, Qt::CaseInsensitive); }))
      hits.push_back(&passage);
  }
  std::stable_partition(hits.begin(), hits.end(),
                        [](const Passage* hit) { return hit->text == hit->heading; });
  list_->clear();
  for (const Passage* hit : hits) {
    if (list_->count() == kMostHits) break;
    auto* const item =
        new QListWidgetItem(QStringLiteral("%1 – %2\n%3")
                                .arg(hit->heading, titles_[hit->page], excerptOf(hit->text, words.first())),
                            list_);
    item->setData(kPageRole, hit->page);
    item->setData(kPositionRole, hit->position);
  }
  list_->setCurrentRow(0);
  const int found = int(hits.size());
  said_->setText(found == 0          ? tr("No page has these words in one place.")
                 : found > kMostHits ? tr("%1 places, the first %2 are listed").arg(found).arg(kMostHits)
                                     : tr("%1 places", nullptr, found).arg(found));
  said_->show();
}

void ManualWindow::open(const QListWidgetItem* item) {
  if (!item) return;
  const QVariant position = item->data(kPositionRole);
  page_->setSource(urlOf(item->data(kPageRole).toInt()));  // may list other items
  if (position.isValid()) static_cast<ManualPage*>(page_)->goTo(position.toInt());
}

void ManualWindow::mark() {
  QList<QTextEdit::ExtraSelection> found;
  QTextCharFormat format;
  format.setBackground(appColors().accent);
  format.setForeground(Qt::white);
  for (const QString& word : searchedWords(search_->text())) {
    const QTextDocument* const text = page_->document();
    for (auto at = text->find(word); !at.isNull() && found.size() < kMostMarks; at = text->find(word, at))
      found << QTextEdit::ExtraSelection{at, format};
  }
  page_->setExtraSelections(found);
}

bool ManualWindow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == search_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape && !search_->text().isEmpty()) {
      search_->clear();
      return true;
    }
    if (key == Qt::Key_Up || key == Qt::Key_Down) return QCoreApplication::sendEvent(list_, event);
  }
  return QDialog::eventFilter(watched, event);
}

}  // namespace mapwright::ui

#include "moc_manual_window.cpp"
