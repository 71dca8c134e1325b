// The window in Chinese: every panel opens, nothing on it is cut off, and what is looked for is found in both
// languages.
#include <functional>

#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QFontDatabase>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QRegularExpression>
#include <QTabBar>
#include <QToolButton>
#include <QtTest>

#include "app/display.h"
#include "app/robot_access.h"
#include "sentences/language.h"
#include "session/submap_tally.h"
#include "shown_window.h"
#include "test_program.h"
#include "ui/kit/actions.h"
#include "ui/slam/submap_filter.h"
#include "ui/window/command_palette.h"
#include "ui/window/language_controller.h"

namespace test_chinese_window {

using namespace mapwright;

namespace {

bool isChinese(const QString& text) {
  static const QRegularExpression kHan(QStringLiteral("\\p{Han}"));
  return text.contains(kHan);
}

QString withoutKey(QString text) {
  static const QRegularExpression kKey(QStringLiteral("&(?!&)"));
  return text.remove(kKey);
}

/// Of the longest line.
int widthOf(const QWidget& widget, const QString& text) {
  int width = 0;
  for (const QString& line : text.split(QLatin1Char('\n')))
    width = std::max(width, widget.fontMetrics().horizontalAdvance(line));
  return width;
}

/// The room that the words of a button need beside its picture.
int needs(const QAbstractButton& button) {
  int width = widthOf(button, withoutKey(button.text()));
  const auto* const tool = qobject_cast<const QToolButton*>(&button);
  const bool beside = !tool || tool->toolButtonStyle() != Qt::ToolButtonTextUnderIcon;
  if (!button.icon().isNull() && beside) width += button.iconSize().width();
  if (button.isCheckable() && !tool && button.inherits("QCheckBox"))
    width += button.style()->pixelMetric(QStyle::PM_IndicatorWidth);
  return width;
}

bool showsWords(const QAbstractButton& button) {
  if (button.text().isEmpty() || !button.isVisible() || button.visibleRegion().isEmpty()) return false;
  const auto* const tool = qobject_cast<const QToolButton*>(&button);
  return !tool || (tool->toolButtonStyle() != Qt::ToolButtonIconOnly || tool->icon().isNull());
}

constexpr const char* kOpensDialogs[] = {
    "connect",  "goTo",           "diagnostics", "about",           "shortcuts",      "export",
    "openFile", "screenshotSave", "record",      "importWaypoints", "exportWaypoints"};

/// Each has a key where it has one (&).
QStringList wordsWithKeysOn(const QWidget& top) {
  QStringList words;
  for (const auto* button : top.findChildren<QAbstractButton*>()) {
    if (!button->isHidden()) words << button->text();
  }
  for (const auto* label : top.findChildren<QLabel*>()) {
    if (label->buddy() && !label->isHidden()) words << label->text();
  }
  for (const auto* box : top.findChildren<QGroupBox*>()) words << box->title();
  for (const auto* bar : top.findChildren<QTabBar*>()) {
    for (int i = 0; i < bar->count(); ++i) words << bar->tabText(i);
  }
  return words;
}

/// What of the words below a widget finds no room; `seen` counts all of them.
QStringList cutBelow(const QWidget& top, int& seen) {
  QStringList cut;
  const auto see = [&](const QWidget& widget, const QString& text, int needed, int room) {
    ++seen;
    if (needed > room)
      cut << QStringLiteral("%1: \"%2\" needs %3 px and has %4")
                 .arg(QLatin1String(widget.metaObject()->className()), text)
                 .arg(needed)
                 .arg(room);
  };
  for (const auto* button : top.findChildren<QAbstractButton*>()) {
    if (showsWords(*button)) see(*button, button->text(), needs(*button), button->width());
  }
  for (const auto* bar : top.findChildren<QTabBar*>()) {
    for (int i = 0; bar->isVisible() && i < bar->count(); ++i)
      see(*bar, bar->tabText(i), widthOf(*bar, withoutKey(bar->tabText(i))), bar->tabRect(i).width());
  }
  for (const auto* label : top.findChildren<QLabel*>()) {
    const bool plain = !Qt::mightBeRichText(label->text()) && !label->wordWrap() && label->pixmap().isNull();
    if (plain && label->isVisible() && !label->inherits("mapwright::ui::PlainLabel") &&
        !label->visibleRegion().isEmpty())
      see(*label, label->text(), widthOf(*label, withoutKey(label->text())), label->width());
  }
  return cut;
}

}  // namespace

class ChineseWindowTest : public QObject {
  Q_OBJECT

  std::unique_ptr<test::ShownWindow> show() {
    auto shown = std::make_unique<test::ShownWindow>(
        [](const QString& to, const QByteArray&) { return app::makeRobot(to, {}, app::DemoTime::Running); });
    if (!shown->connectTo(QStringLiteral("demo:?submaps=12"))) return nullptr;
    return QTest::qWaitFor([&] { return shown->mapsSettled(); }, 60'000) ? std::move(shown) : nullptr;
  }

  /// One after the other; each is shown to `look`, and closed.
  void openDialogs(ui::MainWindow& window, const std::function<void(const QDialog&)>& look) {
    QSet<QString> seen;
    QTimer looks;
    looks.setInterval(10);
    connect(&looks, &QTimer::timeout, this, [&] {
      for (QWidget* top : QApplication::topLevelWidgets()) {
        auto* const dialog = qobject_cast<QDialog*>(top);
        if (!dialog || !dialog->isVisible()) continue;
        look(*dialog);
        seen << dialog->windowTitle();
        dialog->reject();
      }
    });
    looks.start();
    for (const char* id : kOpensDialogs) {
      QAction* const action = window.actionList().find(QLatin1String(id));
      QVERIFY2(action, id);
      if (!action->isEnabled()) continue;
      const auto before = seen.size();
      action->trigger();
      QTRY_VERIFY2(seen.size() > before, id);
    }
    QVERIFY2(seen.size() >= 6, qPrintable(QStringList(seen.begin(), seen.end()).join(QLatin1Char(' '))));
  }

 private Q_SLOTS:
  void initTestCase() {
    (void)app::addLettersOf(QStringLiteral("zh_CN"));
    sentences::speak(QStringLiteral("zh_CN"));
  }

  void everyMenuIsInChinese() {
    const auto shown = show();
    QVERIFY(shown);
    for (const QAction* menu : shown->window().menuBar()->actions()) {
      QVERIFY2(isChinese(menu->text()), qPrintable(menu->text()));
      QVERIFY(menu->text().contains(QLatin1Char('&')));
    }
  }

  void everyPanelOpensAndNothingOnItIsCutOff_data() {
    QTest::addColumn<QSize>("size");
    QTest::newRow("small") << QSize(1366, 768);
    QTest::newRow("usual") << QSize(1920, 1080);
  }
  void everyPanelOpensAndNothingOnItIsCutOff() {
    QFETCH(QSize, size);
    const auto shown = show();
    QVERIFY(shown);
    shown->window().resize(size);
    QStringList cut;
    int panels = 0, words_seen = 0;
    for (QDockWidget* dock : shown->window().findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly)) {
      QAction* const toggle = dock->toggleViewAction();
      QVERIFY2(isChinese(toggle->text()), qPrintable(dock->objectName() + toggle->text()));
      dock->show();
      dock->raise();
      QTRY_VERIFY2(dock->isVisible() && !dock->visibleRegion().isEmpty(), qPrintable(dock->objectName()));
      QCoreApplication::processEvents();
      for (const QString& each : cutBelow(*dock, words_seen))
        cut << dock->objectName() + QStringLiteral(": ") + each;
      ++panels;
    }
    QVERIFY(panels > 20);
    QVERIFY2(words_seen > 100, qPrintable(QString::number(words_seen)));
    QVERIFY2(cut.isEmpty(), qPrintable(QLatin1Char('\n') + cut.join(QLatin1Char('\n'))));
  }

  void dialogsHaveRoomForTheirWords() {
    const auto shown = show();
    QVERIFY(shown);
    QStringList cut;
    int words_seen = 0;
    openDialogs(shown->window(), [&](const QDialog& dialog) {
      for (const QString& each : cutBelow(dialog, words_seen))
        cut << dialog.windowTitle() + QStringLiteral(": ") + each;
    });
    QVERIFY2(words_seen > 30, qPrintable(QString::number(words_seen)));
    QVERIFY2(cut.isEmpty(), qPrintable(QLatin1Char('\n') + cut.join(QLatin1Char('\n'))));
  }

  void noKeyStandsForTwoWords_data() {
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << QStringLiteral("en");
    QTest::newRow("Chinese") << QStringLiteral("zh_CN");
  }
  void noKeyStandsForTwoWords() {
    QFETCH(QString, language);
    sentences::speak(language);
    const auto back = qScopeGuard([] { sentences::speak(QStringLiteral("zh_CN")); });
    const auto shown = show();
    QVERIFY(shown);
    QStringList twice;
    int keys = 0;
    const auto see = [&](const QString& where, const QStringList& texts) {
      QMap<QString, QString> taken;
      for (const QString& text : texts) {
        const QString key = QKeySequence::mnemonic(text).toString();
        if (key.isEmpty()) continue;
        ++keys;
        if (taken.contains(key))
          twice << where + QStringLiteral(": ") + taken.value(key) + QStringLiteral(" and ") + text;
        taken.insert(key, text);
      }
    };
    QStringList bar;
    for (const QAction* menu : shown->window().menuBar()->actions()) bar << menu->text();
    see(QStringLiteral("menu bar"), bar);
    for (const QMenu* menu : shown->window().menuBar()->findChildren<QMenu*>()) {
      QStringList texts;
      for (const QAction* action : menu->actions()) {
        if (action->isVisible()) texts << action->text();
      }
      see(menu->title(), texts);
    }
    for (const QDockWidget* dock : shown->window().findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly))
      see(dock->windowTitle(), wordsWithKeysOn(*dock));
    openDialogs(shown->window(),
                [&](const QDialog& dialog) { see(dialog.windowTitle(), wordsWithKeysOn(dialog)); });
    QVERIFY2(keys > 60, qPrintable(QString::number(keys)));
    QVERIFY2(twice.isEmpty(), qPrintable(QLatin1Char('\n') + twice.join(QLatin1Char('\n'))));
  }

  void thePaletteFindsACommandByBothOfItsNames_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("id");
    const auto row = [](const char* typed, const char* id) {
      QTest::addRow("%s: %s", typed, id) << QString::fromUtf8(typed) << QString::fromLatin1(id);
    };
    row("dark theme", "themeDark");
    row("深色", "themeDark");
    row("panel: layers", "layers");
    row("图层", "layers");
    row("full screen", "fullScreen");
    row("语言", "language_en");
    row("that of the system", "language_system");
    row("language", "language_system");
    row("language", "language_en");
    row("language", "language_zh_CN");
  }
  void thePaletteFindsACommandByBothOfItsNames() {
    QFETCH(QString, typed);
    QFETCH(QString, id);
    const auto shown = show();
    QVERIFY(shown);
    ui::CommandPalette palette(shown->window().actionList(), ui::Findings(), &shown->window());
    palette.field()->setText(typed);
    QStringList found;
    for (int i = 0; i < palette.list()->count(); ++i) found << palette.list()->item(i)->text();
    const QDockWidget* const dock = shown->window().findChild<QDockWidget*>(id);
    const QAction* const wanted = dock ? dock->toggleViewAction() : shown->window().actionList().find(id);
    QVERIFY(wanted);
    QString name;
    for (const ui::Actions::Entry& entry : shown->window().actionList().entries()) {
      if (entry.action == wanted) name = ui::nameAlone(entry);
    }
    QVERIFY(!name.isEmpty());
    QVERIFY2(
        std::any_of(found.begin(), found.end(), [&](const QString& each) { return each.contains(name); }),
        qPrintable(name + QStringLiteral(": ") + found.join(QLatin1Char(' '))));
  }

  void submapsAreFilteredByTheWordsOfBothLanguages() {
    ui::SubmapFacts facts;
    facts.frozen = true;
    facts.status = session::SubmapStatus::Waiting;
    for (const char* typed : {"frozen", "冻结", "failed", "失败", "冻结 failed"})
      QVERIFY2(ui::SubmapFilter(QString::fromUtf8(typed)).matches(facts), typed);
    QVERIFY(!ui::SubmapFilter(QStringLiteral("活动")).matches(facts));
  }

  void namesOfCommandsHaveNoKeyBehindThem() {
    const auto shown = show();
    QVERIFY(shown);
    static const QRegularExpression kKey(QStringLiteral("\\([A-Z]\\)"));
    for (const ui::Actions::Entry& entry : shown->window().actionList().entries()) {
      const QString name = ui::nameAlone(entry);
      QVERIFY2(!name.contains(kKey) && !entry.menu.contains(kKey), qPrintable(name));
    }
  }

  void anotherLanguageIsSpokenFromTheNextStartOn() {
    const auto shown = show();
    QVERIFY(shown);
    const auto* const languages = shown->window().findChild<ui::LanguageController*>();
    shown->window().actionList().find(QStringLiteral("language_zh_CN"))->trigger();
    QVERIFY(!languages->remark());  // it is in force
    shown->window().actionList().find(QStringLiteral("language_en"))->trigger();
    QVERIFY(languages->remark());
    QVERIFY(languages->remark()->text().contains(QStringLiteral("English")));
    QVERIFY(isChinese(languages->remark()->text()));
    languages->remark()->reject();
  }
};

}  // namespace test_chinese_window

MAPWRIGHT_TEST(test_chinese_window, ChineseWindowTest, Widgets)
#include "test_chinese_window.moc"
