#include "window/recordings/record_dialog.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpressionValidator>
#include <QSpinBox>
#include <QVBoxLayout>

namespace mapwright::window {

namespace {

constexpr int kLongestS = 3600;
constexpr int kSuffixLength = 60;

}  // namespace

RecordDialog::RecordDialog(QWidget* parent)
    : QDialog(parent), suffix_(new QLineEdit(this)), duration_(new QSpinBox(this)) {
  setWindowTitle(tr("Record on the robot"));
  setMinimumWidth(380);
  suffix_->setMaxLength(kSuffixLength);
  suffix_->setPlaceholderText(tr("none"));
  // It becomes part of a file name on the robot.
  suffix_->setValidator(
      new QRegularExpressionValidator(QRegularExpression(QStringLiteral("[A-Za-z0-9_.-]*")), suffix_));
  duration_->setRange(0, kLongestS);
  duration_->setSpecialValueText(tr("as the robot thinks right"));
  duration_->setSuffix(tr(" s"));
  auto* const form = new QFormLayout;
  form->addRow(tr("&Suffix of the name"), suffix_);
  form->addRow(tr("&Duration"), duration_);
  auto* const record = new QPushButton(tr("Record"), this);
  record->setObjectName(QStringLiteral("primary"));
  record->setDefault(true);
  auto* const cancel = new QPushButton(tr("Cancel"), this);
  cancel->setObjectName(QStringLiteral("secondary"));
  cancel->setAutoDefault(false);
  auto* const buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addStretch();
  buttons->addWidget(cancel);
  buttons->addWidget(record);
  auto* const column = new QVBoxLayout(this);
  column->setSpacing(12);
  column->addLayout(form);
  column->addLayout(buttons);
  connect(record, &QPushButton::clicked, this, &QDialog::accept);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
}

robot::BagOrder RecordDialog::order() const {
  robot::BagOrder order;
  order.suffix = suffix_->text().toStdString();
  if (duration_->value() > 0) order.duration = std::to_string(duration_->value()) + "s";
  return order;
}

}  // namespace mapwright::window
