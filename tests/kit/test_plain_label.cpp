// Labels of plain text that may take several lines.
#include <QTest>
#include <QVBoxLayout>

#include "test_program.h"
#include "ui/kit/plain_label.h"

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
};

}  // namespace test_plain_label

MAPWRIGHT_TEST(test_plain_label, TestPlainLabel, Widgets)
#include "test_plain_label.moc"
