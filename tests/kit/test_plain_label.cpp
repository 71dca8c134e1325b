// Labels: lines and colours.
#include <QLabel>
#include <QTest>
#include <QVBoxLayout>

#include "test_program.h"
#include "ui/kit/forms.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/theme.h"
#include "ui/kit/ui_colors.h"

namespace test_plain_label {

using namespace mapwright;

class TestPlainLabel : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void allItsLinesAreSeen() {
    QWidget panel;
    auto* const label = new ui::PlainLabel(&panel);
    label->setMostLines(2);
    auto* const layout = new QVBoxLayout(&panel);
    layout->addWidget(label);
    layout->addStretch(1);
    panel.resize(300, 200);
    label->setText(QStringLiteral("Short."));
    layout->activate();
    const int one = label->height();
    label->setText(QStringLiteral("A sentence that is too long for a panel of this width by a few words."));
    layout->activate();
    QVERIFY(label->height() >= one + label->fontMetrics().lineSpacing());
    label->setText(QStringLiteral("Short."));
    layout->activate();
    QCOMPARE(label->height(), one);
  }

  void aTextIsReadableAfterTheThemeWasChanged() {
    ui::applyTheme(*qApp, ui::ThemeChoice::Light);
    QLabel quiet(QStringLiteral("3 waypoints."));
    QLabel changing(QStringLiteral("It could not be read."));
    ui::setTextColor(quiet, ui::appColors().secondary_text);
    ui::setTextColor(changing, ui::appColors().secondary_text);
    ui::setTextColor(changing, ui::appColors().error_text);
    quiet.show();
    changing.show();
    for (const auto choice : {ui::ThemeChoice::Dark, ui::ThemeChoice::Light, ui::ThemeChoice::Dark}) {
      ui::applyTheme(*qApp, choice);
      QCOMPARE(quiet.palette().color(QPalette::WindowText), ui::appColors().secondary_text);
      QCOMPARE(changing.palette().color(QPalette::WindowText), ui::appColors().error_text);
    }
    ui::applyTheme(*qApp, ui::ThemeChoice::System);
  }
};

}  // namespace test_plain_label

MAPWRIGHT_TEST(test_plain_label, TestPlainLabel, Widgets)
#include "test_plain_label.moc"
