// Both themes, looked at as they are painted: every widget that the window uses, in every state, can be told
// from what it stands on.
#include <functional>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollBar>
#include <QStandardItemModel>
#include <QTabBar>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <QtTest>

#include "test_program.h"
#include "ui/kit/icons.h"
#include "ui/kit/state_mark.h"
#include "ui/kit/theme.h"
#include "ui/kit/tree_view.h"
#include "ui/kit/ui_colors.h"
#include "ui/layers/layer_row.h"

namespace test_window_look {

using namespace mapwright::ui;

namespace {

constexpr double kForWords = 4.5, kForMarks = 3.0;

/// The strongest contrast that any pixel has with `ground`.
double strongest(const QImage& image, const QColor& ground) {
  double best = 1;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x)
      best = std::max(best, contrastRatio(image.pixelColor(x, y), ground));
  }
  return best;
}

/// The strongest contrast between a pixel and what was there before.
double strongestChange(const QImage& before, const QImage& after) {
  double best = 1;
  for (int y = 0; y < after.height(); ++y) {
    for (int x = 0; x < after.width(); ++x) {
      if (before.pixel(x, y) != after.pixel(x, y))
        best = std::max(best, contrastRatio(before.pixelColor(x, y), after.pixelColor(x, y)));
    }
  }
  return best;
}

/// A window with a button that holds the focus until somebody else gets it.
struct Stage {
  Stage() : other(new QPushButton(QStringLiteral("other"), &window)), column(new QVBoxLayout(&window)) {
    column->addWidget(other);
  }
  template <typename Widget>
  Widget* add(Widget* widget) {
    column->addWidget(widget);
    return widget;
  }
  void show() {
    window.resize(240, 160);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    other->setFocus();
  }
  QWidget window;
  QPushButton* other;
  QVBoxLayout* column;
};

QImage look(QWidget* widget) {
  return widget->window()->grab(QRect(widget->mapTo(widget->window(), QPoint()), widget->size())).toImage();
}

/// The part of a button that is its mark and not its words.
QImage markOf(QWidget* widget) { return look(widget).copy(0, 0, 19, widget->height()); }

void themes() {
  QTest::addColumn<bool>("dark");
  QTest::newRow("light") << false;
  QTest::newRow("dark") << true;
}

void apply(bool dark) { applyTheme(*qApp, dark ? ThemeChoice::Dark : ThemeChoice::Light); }

}  // namespace

class TestWindowLook : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void cleanupTestCase() { applyTheme(*qApp, ThemeChoice::System); }

  void aMarkInATableIsMadeOnceForEachTheme() {
    apply(false);
    const QPixmap light = markPixmap(Mark::Bad);
    QCOMPARE(markPixmap(Mark::Bad).cacheKey(), light.cacheKey());
    QVERIFY(markPixmap(Mark::Good).toImage() != light.toImage());
    apply(true);
    QVERIFY(markPixmap(Mark::Bad).toImage() != light.toImage());
    apply(false);
    QCOMPARE(markPixmap(Mark::Bad).cacheKey(), light.cacheKey());
  }

  void wordsAndShapesCanBeTold_data() { themes(); }
  void wordsAndShapesCanBeTold() {
    QFETCH(bool, dark);
    const UiColors c = uiColors(dark);
    const auto check = [](const QColor& ink, const QColor& ground, double least) {
      QVERIFY2(
          contrastRatio(ink, ground) >= least,
          qPrintable(
              QStringLiteral("%1 on %2: %3").arg(ink.name(), ground.name()).arg(contrastRatio(ink, ground))));
    };
    for (const QColor& ground : {c.window, c.base, c.hover, c.selection, c.tooltip}) {
      for (const QColor& ink :
           {c.text, c.secondary_text, c.accent_text, c.ok_text, c.warning_text, c.error_text})
        check(ink, ground, kForWords);
      for (const QColor& ink : {c.ok, c.warning, c.error, c.neutral, c.focus}) check(ink, ground, kForMarks);
    }
    for (const QColor& ground : {c.window, c.base}) {
      for (const QColor& ink : {c.outline, c.disabled}) check(ink, ground, kForMarks);
    }
    check(Qt::white, c.accent, kForWords);
    for (const Mark mark : {Mark::Good, Mark::Busy, Mark::Warning, Mark::Bad, Mark::Neutral})
      check(markColor(mark, c), c.selection, kForMarks);
  }

  void tickMarksAreSeen_data() {
    QTest::addColumn<bool>("dark");
    QTest::addColumn<bool>("radio");
    QTest::addColumn<int>("state");
    QTest::addColumn<bool>("enabled");
    for (const bool dark : {false, true}) {
      for (const bool radio : {false, true}) {
        for (const int state : {0, 1, 2}) {
          if (radio && state == 1) continue;
          for (const bool enabled : {true, false}) {
            QTest::addRow("%s %s %d %s", dark ? "dark" : "light", radio ? "radio" : "box", state,
                          enabled ? "enabled" : "disabled")
                << dark << radio << state << enabled;
          }
        }
      }
    }
  }
  void tickMarksAreSeen() {
    QFETCH(bool, dark);
    QFETCH(bool, radio);
    QFETCH(int, state);
    QFETCH(bool, enabled);
    apply(dark);
    Stage stage;
    QAbstractButton* button = nullptr;
    if (radio) {
      button = stage.add(new QRadioButton(QStringLiteral("Words")));
      button->setChecked(state == 2);
    } else {
      auto* box = stage.add(new QCheckBox(QStringLiteral("Words")));
      box->setTristate(state == 1);
      box->setCheckState(Qt::CheckState(state));
      button = box;
    }
    button->setEnabled(enabled);
    stage.show();
    const QColor ground = appColors().window;
    QVERIFY(strongest(markOf(button), ground) >= kForMarks);
    // Ticked and not ticked differ by more than a shade.
    const QImage before = markOf(button);
    if (state == 2) {
      if (radio) button->setAutoExclusive(false);
      button->setChecked(false);
      QVERIFY(strongestChange(before, markOf(button)) >= kForMarks);
    }
  }

  void focusIsSeen_data() { themes(); }
  void focusIsSeen() {
    QFETCH(bool, dark);
    apply(dark);
    const auto named = [](auto* widget, const char* name) {
      widget->setObjectName(QLatin1String(name));
      return widget;
    };
    Stage stage;
    const QList<QWidget*> widgets{
        stage.add(new QRadioButton(QStringLiteral("Words"))),
        stage.add(new QCheckBox(QStringLiteral("Words"))),
        stage.add(new QLineEdit(QStringLiteral("Words"))),
        stage.add(new QComboBox),
        stage.add(new QDoubleSpinBox),
        stage.add(new OpacitySlider),
        stage.add(new QToolButton),
        stage.add(named(new QPushButton(QStringLiteral("Words")), "primary")),
        stage.add(named(new QPushButton(QStringLiteral("Words")), "secondary")),
        stage.add(named(new QPushButton(QStringLiteral("Words")), "compact")),
        stage.add(named(new QListWidget, "recents")),
    };
    stage.show();
    for (QWidget* widget : widgets) {
      if (auto* field = qobject_cast<QLineEdit*>(widget)) field->deselect();
      stage.other->setFocus();
      const QImage without = look(widget);
      widget->setFocus(Qt::TabFocusReason);
      if (auto* field = qobject_cast<QLineEdit*>(widget)) field->deselect();
      const QImage with = look(widget);
      QVERIFY2(with != without, widget->metaObject()->className());
      double best = 1;
      for (int y = 0; y < with.height(); ++y) {
        for (int x = 0; x < with.width(); ++x) {
          if (with.pixel(x, y) != without.pixel(x, y))
            best = std::max(best, contrastRatio(with.pixelColor(x, y), appColors().window));
        }
      }
      QVERIFY2(best >= kForMarks,
               qPrintable(QStringLiteral("%1 %2 %3")
                              .arg(QLatin1String(widget->metaObject()->className()), widget->objectName())
                              .arg(best)));
    }
  }

  void edgesOfFieldsAndButtonsAreSeen_data() { themes(); }
  void edgesOfFieldsAndButtonsAreSeen() {
    QFETCH(bool, dark);
    apply(dark);
    Stage stage;
    QList<QWidget*> widgets{stage.add(new QLineEdit), stage.add(new QComboBox),
                            stage.add(new QDoubleSpinBox)};
    for (const char* name : {"primary", "secondary", "compact"}) {
      auto* button = stage.add(new QPushButton(QStringLiteral("Words")));
      button->setObjectName(QLatin1String(name));
      widgets << button;
    }
    stage.show();
    for (QWidget* widget : widgets) {
      const QImage image = look(widget);
      const QImage edge = image.copy(0, image.height() / 2, 3, 1);
      QVERIFY2(strongest(edge, appColors().window) >= kForMarks,
               qPrintable(QLatin1String(widget->metaObject()->className()) + widget->objectName()));
    }
  }

  void wordsOfDisabledWidgetsCanStillBeRead_data() { themes(); }
  void wordsOfDisabledWidgetsCanStillBeRead() {
    QFETCH(bool, dark);
    apply(dark);
    Stage stage;
    QList<QWidget*> widgets{stage.add(new QLabel(QStringLiteral("MMMM"))),
                            stage.add(new QLineEdit(QStringLiteral("MMMM")))};
    auto* combo = stage.add(new QComboBox);
    combo->addItem(QStringLiteral("MMMM"));
    widgets << combo;
    for (const char* name : {"primary", "secondary", "compact"}) {
      auto* button = stage.add(new QPushButton(QStringLiteral("MMMM")));
      button->setObjectName(QLatin1String(name));
      widgets << button;
    }
    for (QWidget* widget : widgets) widget->setEnabled(false);
    stage.show();
    for (QWidget* widget : widgets) {
      const QImage image = look(widget).copy(4, 4, widget->width() - 28, widget->height() - 8);
      QVERIFY2(strongest(image, appColors().window) >= kForMarks,
               qPrintable(QLatin1String(widget->metaObject()->className()) + widget->objectName()));
    }
  }

  void selectedRowsAreToldByMoreThanATint_data() { themes(); }
  void selectedRowsAreToldByMoreThanATint() {
    QFETCH(bool, dark);
    apply(dark);
    QStandardItemModel model(3, 2);
    Stage stage;
    auto* tree = stage.add(new TreeView);
    auto* table = stage.add(new QuietTableView);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setItemDelegate(new TableRowDelegate(table));
    table->verticalHeader()->hide();
    for (QAbstractItemView* view :
         {static_cast<QAbstractItemView*>(tree), static_cast<QAbstractItemView*>(table)}) {
      view->setModel(&model);
      view->setMinimumHeight(90);
    }
    stage.show();
    for (QAbstractItemView* view :
         {static_cast<QAbstractItemView*>(tree), static_cast<QAbstractItemView*>(table)}) {
      const auto row = [&] {
        QRect rect = view->visualRect(model.index(1, 0));
        rect.setLeft(0);
        return view->viewport()->grab(rect).toImage();
      };
      const QImage before = row();
      view->setCurrentIndex(model.index(1, 0));
      QVERIFY2(strongestChange(before, row()) >= kForMarks, view->metaObject()->className());
    }
  }
};

}  // namespace test_window_look

MAPWRIGHT_TEST(test_window_look, TestWindowLook, Widgets)
#include "test_window_look.moc"
