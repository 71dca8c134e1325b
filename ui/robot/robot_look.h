// What people call a robot, and the colour that they give it.
#pragma once

#include <vector>

#include <QColor>
#include <QDialog>
#include <QIcon>
#include <QRectF>
#include <QString>

class QComboBox;
class QLineEdit;
class QPainter;

namespace mapwright::ui {

struct RobotLook {
  QString called;  // one line; empty = as it calls itself
  QString color;   // the id of one of robotColors(); empty = none
  bool operator==(const RobotLook&) const = default;
};

struct RobotColor {
  QString id, name;  // "green", "Green"
  QColor color;
};
const std::vector<RobotColor>& robotColors();
/// Invalid for an unknown id.
QColor robotColor(const QString& id);
/// A square with rounded corners. Nothing for an invalid colour.
void paintRobotColor(QPainter& painter, const QRectF& where, const QColor& color);
QIcon robotColorIcon(const QColor& color);

/// The two fields, for forms.
struct LookFields {
  explicit LookFields(QWidget* parent);
  RobotLook look() const;
  void setLook(const RobotLook& look);
  QLineEdit* name;
  QComboBox* color;
};

/// Asks for both; saves nothing.
class RobotLookDialog : public QDialog {
  Q_OBJECT
 public:
  /// `own_name`: what it calls itself.
  RobotLookDialog(const RobotLook& look, const QString& own_name, QWidget* parent = nullptr);
  RobotLook look() const { return fields_.look(); }

 private:
  LookFields fields_;
};

}  // namespace mapwright::ui
