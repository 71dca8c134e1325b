// The manual in the window: opened by F1, searched, its links followed.
#include <map>

#include <QApplication>
#include <QDirIterator>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolButton>

#include "test_program.h"
#include "ui/window/manual_window.h"
#include "window_bench.h"

namespace test_window_manual {

using namespace mapwright;
using namespace mapwright::ui;
using test::Bench;

/// A window with the manual open, as hands find it.
struct Reader {
  explicit Reader(const QSize& size = {1366, 768}) {
    bench.open(size);
    bench.key(Qt::Key_F1);
    manual = bench.window->findChild<ManualWindow*>();
    if (!manual) return;
    // Qt 6.5 and later would rather have activateWindow(), which needs a window system.
    QT_WARNING_PUSH
    QT_WARNING_DISABLE_DEPRECATED
    QApplication::setActiveWindow(manual);
    QT_WARNING_POP
    search = manual->findChild<QLineEdit*>();
    list = manual->findChild<QListWidget*>();
    page = manual->findChild<QTextBrowser*>();
  }
  void click(int row) const {
    list->scrollToItem(list->item(row));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(row)).center());
  }

  Bench bench;
  ManualWindow* manual = nullptr;
  QLineEdit* search = nullptr;
  QListWidget* list = nullptr;
  QTextBrowser* page = nullptr;
};

QString asLinksSay(const QString& heading) {
  static const QRegularExpression odd(QStringLiteral("[^\\w -]"));
  return heading.toLower().remove(odd).replace(QLatin1Char(' '), QLatin1Char('-'));
}

class WindowManualTest : public QObject {
  Q_OBJECT
 private:
  /// The formats of all pieces of a page that lead somewhere or show a picture.
  static QList<QTextCharFormat> linksAndPicturesOf(const QTextDocument& document) {
    QList<QTextCharFormat> formats;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
      for (auto piece = block.begin(); !piece.atEnd(); ++piece) {
        const QTextCharFormat format = piece.fragment().charFormat();
        if (format.isImageFormat() || !format.anchorHref().isEmpty()) formats << format;
      }
    }
    return formats;
  }

 private Q_SLOTS:
  void f1OpensIt() {
    const Reader reader;
    QVERIFY(reader.manual && reader.manual->isVisible());
    QVERIFY(!reader.manual->isModal());
    QCOMPARE(reader.bench.window->findChildren<ManualWindow*>().size(), 1);
    QVERIFY(reader.page->toPlainText().size() > 1000);
  }

  void everyPageOfTheResourceIsListedAndOpens() {
    const Reader reader;
    QSet<QString> stored, opened;
    QDirIterator it(QStringLiteral(":/manual"), {QStringLiteral("*.md")}, QDir::Files,
                    QDirIterator::Subdirectories);
    while (it.hasNext()) stored << it.next();
    for (int row = 0; row < reader.list->count(); ++row) {
      reader.click(row);
      const QString title = reader.list->item(row)->text();
      QCOMPARE(reader.list->currentRow(), row);
      QVERIFY(!title.isEmpty() && reader.page->document()->begin().text() == title);
      opened << QLatin1Char(':') + reader.page->source().path();
    }
    QCOMPARE(opened, stored);
  }

  void everyLinkInsideLeadsThere() {
    const Reader reader;
    std::map<QString, QStringList> from;  // by where they lead
    for (int row = 0; row < reader.list->count(); ++row) {
      reader.click(row);
      const QUrl here = reader.page->source();
      for (const QTextCharFormat& format : linksAndPicturesOf(*reader.page->document())) {
        const QUrl to =
            here.resolved(QUrl(format.isImageFormat() ? format.toImageFormat().name() : format.anchorHref()));
        // Folders of examples are beside the documents, not in the window.
        const bool is_inside = to.path().endsWith(QLatin1String(".md")) || format.isImageFormat();
        if (to.scheme() == QLatin1String("qrc") && is_inside) from[to.toString()] << here.path();
      }
    }
    QVERIFY(from.size() > 30);
    QStringList dead;
    for (const auto& [to, pages] : from) {
      const QUrl url(to);
      bool leads = QFile::exists(QLatin1Char(':') + url.path());
      if (leads && url.hasFragment()) {
        reader.page->setSource(url);
        leads = asLinksSay(reader.page->textCursor().block().text()) == url.fragment();
      }
      if (!leads) dead << to + QStringLiteral(" from ") + pages.join(QLatin1Char(' '));
    }
    QVERIFY2(dead.isEmpty(), qPrintable(dead.join(QLatin1Char('\n'))));
  }

  void aSearchGoesToWhatItFinds() {
    const Reader reader;
    QVERIFY(reader.search->hasFocus());
    QTest::keyClicks(reader.search, QStringLiteral("json topics"));
    QVERIFY(reader.list->count() > 0);
    for (int row = 0; row < reader.list->count(); ++row)
      QVERIFY(reader.list->item(row)->text().contains(QLatin1Char('\n')));
    // Down chooses, Enter goes there.
    if (reader.list->count() > 1) QTest::keyClick(reader.search, Qt::Key_Down);
    QCOMPARE(reader.list->currentRow(), reader.list->count() > 1 ? 1 : 0);
    QTest::keyClick(reader.search, Qt::Key_Return);
    QVERIFY(reader.manual->isVisible());
    QVERIFY(reader.page->textCursor().block().isValid());
    QVERIFY(!reader.page->extraSelections().isEmpty());
    const QRect shown = reader.page->cursorRect();
    QVERIFY(reader.page->viewport()->rect().intersects(shown));
    bool marks_it = false;
    for (const QTextEdit::ExtraSelection& mark : reader.page->extraSelections())
      marks_it |= reader.page->viewport()->rect().intersects(reader.page->cursorRect(mark.cursor));
    QVERIFY(marks_it);
  }

  void headingsComeFirst() {
    const Reader reader;
    QTest::keyClicks(reader.search, QStringLiteral("waypoints"));
    QVERIFY(reader.list->item(0)->text().startsWith(QLatin1String("Edit waypoints"), Qt::CaseInsensitive) ||
            reader.list->item(0)->text().startsWith(QLatin1String("Waypoints"), Qt::CaseInsensitive));
  }

  void whatIsNowhereIsSaid() {
    const Reader reader;
    QTest::keyClicks(reader.search, QStringLiteral("qxqxqx"));
    QCOMPARE(reader.list->count(), 0);
    bool said = false;
    for (const QLabel* label : reader.manual->findChildren<QLabel*>())
      said |= label->isVisible() && label->text().startsWith(QLatin1String("No page"));
    QVERIFY(said);
  }

  void aLinkLeadsToAnotherPageAndBackAgain() {
    const Reader reader;
    const QUrl here = reader.page->source();
    QTextCursor link;
    for (QTextBlock block = reader.page->document()->begin(); block.isValid() && link.isNull();
         block = block.next()) {
      for (auto piece = block.begin(); !piece.atEnd(); ++piece) {
        const QString href = piece.fragment().charFormat().anchorHref();
        if (href.section(QLatin1Char('#'), 0, 0).endsWith(QLatin1String(".md")) && link.isNull()) {
          link = QTextCursor(block);
          link.setPosition(piece.fragment().position() + 2);
        }
      }
    }
    QVERIFY(!link.isNull());
    const QString to = link.charFormat().anchorHref();
    reader.page->setTextCursor(link);
    QTest::mouseClick(reader.page->viewport(), Qt::LeftButton, {}, reader.page->cursorRect(link).center());
    QCOMPARE(reader.page->source(), here.resolved(QUrl(to)));
    QCOMPARE(reader.list->item(reader.list->currentRow())->text(), reader.page->document()->begin().text());
    auto* const back = reader.manual->findChild<QToolButton*>();
    QVERIFY(back->isEnabled());
    QTest::mouseClick(back, Qt::LeftButton);
    QCOMPARE(reader.page->source(), here);
    QVERIFY(!back->isEnabled());
  }

  void keysGoToTheSearchAndClose() {
    Reader reader;
    reader.page->setFocus();
    QTest::keyClick(reader.page, Qt::Key_F, Qt::ControlModifier);
    QVERIFY(reader.search->hasFocus());
    const int pages = reader.list->count();
    QTest::keyClicks(reader.search, QStringLiteral("map"));
    QTest::keyClick(reader.search, Qt::Key_Escape);
    QVERIFY(reader.search->text().isEmpty());
    QCOMPARE(reader.list->count(), pages);
    QTest::keyClick(reader.search, Qt::Key_Escape);
    QVERIFY(!reader.manual->isVisible());
    // Again: the same window, where it was.
    reader.bench.action("manual")->trigger();
    QVERIFY(reader.manual->isVisible());
    QCOMPARE(reader.bench.window->findChildren<ManualWindow*>().size(), 1);
  }

  void picturesFitTheWindow() {
    const Reader reader({1024, 640});
    QVERIFY(reader.manual->height() <= reader.manual->screen()->availableSize().height());
    QCOMPARE(reader.page->horizontalScrollBar()->maximum(), 0);
  }
};

}  // namespace test_window_manual

MAPWRIGHT_TEST(test_window_manual, WindowManualTest, Widgets)
#include "test_window_manual.moc"
