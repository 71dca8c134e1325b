#include "ui/window/go_to_dialog.h"

#include <cmath>

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>

#include "ui/kit/forms.h"
#include "ui/kit/status_text.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::ui {

namespace {

constexpr double kFarthestM = 1e9;  // as --center of commands: maps may lie in UTM coordinates

}  // namespace

std::optional<Eigen::Vector2d> parsePoint(const QString& text) {
  QString plain = text.trimmed().toLower();
  // A comma between digits is a decimal comma only if a semicolon separates the numbers.
  if (plain.contains(QLatin1Char(';'))) plain.replace(QLatin1Char(','), QLatin1Char('.'));
  static const QRegularExpression pattern(QStringLiteral(
      "^(?:x\\s*[=:]?\\s*)?([+-]?(?:\\d+\\.?\\d*|\\.\\d+)(?:e[+-]?\\d+)?)\\s*m?\\s*(?:[,;]|\\s)\\s*"
      "(?:y\\s*[=:]?\\s*)?([+-]?(?:\\d+\\.?\\d*|\\.\\d+)(?:e[+-]?\\d+)?)\\s*m?$"));
  const QRegularExpressionMatch match = pattern.match(plain);
  if (!match.hasMatch()) return std::nullopt;
  const Eigen::Vector2d point(match.captured(1).toDouble(), match.captured(2).toDouble());
  if (!point.allFinite() || point.cwiseAbs().maxCoeff() > kFarthestM) return std::nullopt;
  return point;
}

GoToDialog::GoToDialog(const Eigen::Vector2d& present, QWidget* parent)
    : QDialog(parent),
      field_(new QLineEdit(this)),
      error_(wrappedLabel({}, this)),
      go_(new QPushButton(tr("Go"), this)) {
  setWindowTitle(tr("Go to coordinates"));
  setMinimumWidth(440);
  auto* label = new QLabel(tr("&x, y in metres"), this);
  label->setBuddy(field_);
  field_->setText(coordinatesForClipboard(present));
  field_->selectAll();
  // Room for the sentence from the start: it appears and disappears while typing, and the dialog must not
  // jump.
  error_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  error_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  setTextColor(*error_, appColors().error_text);
  go_->setObjectName(QStringLiteral("primary"));
  go_->setDefault(true);
  auto* cancel = new QPushButton(tr("Cancel"), this);
  cancel->setObjectName(QStringLiteral("secondary"));
  cancel->setAutoDefault(false);
  setLayout(columnOf({label, field_, error_, LayoutItem::gap(4), rowOf({LayoutItem::rest(), cancel, go_}, 8)},
                     8, QMargins(16, 16, 16, 16)));
  connect(field_, &QLineEdit::textChanged, this, &GoToDialog::check);
  connect(go_, &QPushButton::clicked, this, &QDialog::accept);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  check();
}

std::optional<Eigen::Vector2d> GoToDialog::point() const { return parsePoint(field_->text()); }

void GoToDialog::check() {
  const bool fine = point().has_value();
  go_->setEnabled(fine);
  const bool complain = !fine && !field_->text().trimmed().isEmpty();
  error_->setText(complain ? tr("Enter two numbers in metres, for example 12.5, -3.2.") : QString());
}

}  // namespace mapwright::ui

#include "moc_go_to_dialog.cpp"
