#include "ui/robot/robot_look.h"

#include <algorithm>

#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>

#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/kit/ui_colors.h"
#include "words/qt_plain.h"

namespace mapwright::ui {

namespace {

constexpr int kLongestName = 60, kColorIconPx = 16;

QString colorName(const char* name) { return QCoreApplication::translate("window", name); }

}  // namespace

const std::vector<RobotColor>& robotColors() {
  static const std::vector<RobotColor> colors{
      {QStringLiteral("red"), colorName(QT_TRANSLATE_NOOP("window", "Red")), {0xd1, 0x38, 0x3d}},
      {QStringLiteral("orange"), colorName(QT_TRANSLATE_NOOP("window", "Orange")), {0xd9, 0x73, 0x0d}},
      {QStringLiteral("yellow"), colorName(QT_TRANSLATE_NOOP("window", "Yellow")), {0xb8, 0x92, 0x00}},
      {QStringLiteral("green"), colorName(QT_TRANSLATE_NOOP("window", "Green")), {0x2e, 0x9e, 0x5b}},
      {QStringLiteral("teal"), colorName(QT_TRANSLATE_NOOP("window", "Teal")), {0x12, 0x93, 0xa3}},
      {QStringLiteral("blue"), colorName(QT_TRANSLATE_NOOP("window", "Blue")), {0x3b, 0x7d, 0xef}},
      {QStringLiteral("purple"), colorName(QT_TRANSLATE_NOOP("window", "Purple")), {0x8b, 0x5c, 0xdf}},
      {QStringLiteral("pink"), colorName(QT_TRANSLATE_NOOP("window", "Pink")), {0xd6, 0x49, 0x8f}}};
  return colors;
}

QColor robotColor(const QString& id) {
  const auto& all = robotColors();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.id == id; });
  return found == all.end() ? QColor() : found->color;
}

void paintRobotColor(QPainter& painter, const QRectF& where, const QColor& color) {
  if (!color.isValid()) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawRoundedRect(where, 3, 3);
  painter.restore();
}

QIcon robotColorIcon(const QColor& color) {
  QPixmap pixmap(kColorIconPx * 2, kColorIconPx * 2);
  pixmap.setDevicePixelRatio(2);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  paintRobotColor(painter, QRectF(2, 2, kColorIconPx - 4, kColorIconPx - 4), color);
  painter.end();
  return QIcon(pixmap);
}

LookFields::LookFields(QWidget* parent) : name(new QLineEdit(parent)), color(new QComboBox(parent)) {
  name->setObjectName(QStringLiteral("calledName"));
  setLongest(*name, kLongestName);
  color->setObjectName(QStringLiteral("calledColor"));
  color->setAccessibleName(RobotLookDialog::tr("Colour of the robot"));
  color->addItem(robotColorIcon({}), RobotLookDialog::tr("No colour"), QString());
  for (const RobotColor& one : robotColors()) color->addItem(robotColorIcon(one.color), one.name, one.id);
}

RobotLook LookFields::look() const {
  return {words::plainName(name->text().trimmed()), color->currentData().toString()};
}

void LookFields::setLook(const RobotLook& look) {
  name->setText(look.called);
  color->setCurrentIndex(std::max(0, color->findData(look.color)));
}

RobotLookDialog::RobotLookDialog(const RobotLook& look, const QString& own_name, QWidget* parent)
    : QDialog(parent), fields_(this) {
  setWindowTitle(tr("Name and colour"));
  setMinimumWidth(380);
  fields_.setLook(look);
  fields_.name->setPlaceholderText(own_name);
  auto* form = new QFormLayout;
  form->addRow(tr("&Name"), fields_.name);
  form->addRow(tr("&Colour"), fields_.color);
  auto* note = wrappedLabel(tr("They stay on this computer: nothing changes on the robot."), this);
  setTextColor(*note, appColors().secondary_text);
  auto* save = new QPushButton(tr("Save"), this);
  auto* cancel = new QPushButton(tr("Cancel"), this);
  giveRoles(*save, {cancel});
  connect(save, &QPushButton::clicked, this, &QDialog::accept);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  setLayout(columnOf({form, note, LayoutItem::rest(), rowOf({LayoutItem::rest(), cancel, save}, 8)}, 12,
                     QMargins(16, 16, 16, 16)));
  fields_.name->selectAll();
}

}  // namespace mapwright::ui

#include "moc_robot_look.cpp"
