#include "ui/replay/record_dialog.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSpinBox>

#include "ui/kit/dialog_look.h"
#include "ui/kit/forms.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::ui {

namespace {

constexpr int kLongestS = 3600;
constexpr int kSuffixLength = 60;

}  // namespace

RecordDialog::RecordDialog(QWidget* parent)
    : QDialog(parent),
      suffix_(new QLineEdit(this)),
      duration_(new WholeBox(this)),
      record_(new QPushButton(tr("Record"), this)),
      said_(new QLabel(this)) {
  setWindowTitle(tr("Record on the robot"));
  setMinimumWidth(380);
  setLongest(*suffix_, kSuffixLength);
  suffix_->setPlaceholderText(tr("none"));
  said_->setTextFormat(Qt::PlainText);
  said_->setWordWrap(true);
  duration_->setRange(0, kLongestS);
  duration_->setSpecialValueText(tr("robot's default"));
  duration_->setSuffix(tr(" s"));
  auto* const form = new QFormLayout;
  form->addRow(tr("&Suffix of the name"), suffix_);
  form->addRow(tr("&Duration"), duration_);
  auto* const cancel = new QPushButton(tr("Cancel"), this);
  giveRoles(*record_, {cancel});
  setLayout(columnOf({form, said_, rowOf({LayoutItem::rest(), cancel, record_}, 8)}, 12));
  connect(suffix_, &QLineEdit::textChanged, this, &RecordDialog::check);
  connect(record_, &QPushButton::clicked, this, &RecordDialog::recordWanted);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  check();
}

void RecordDialog::say(const QString& sentence, bool bad) {
  bad_ = bad;
  setTextColor(*said_, bad ? appColors().error_text : appColors().secondary_text);
  said_->setText(sentence);
  said_->setVisible(!sentence.isEmpty());
}

void RecordDialog::check() {
  // It becomes part of a file name on the robot. Invalid characters are reported, not removed.
  static const QRegularExpression fits(QStringLiteral("^[A-Za-z0-9_-]*$"));
  const bool good = fits.match(suffix_->text()).hasMatch();
  say(good ? QString() : tr("A suffix may only contain letters from A to Z, digits, - and _."), !good);
  record_->setEnabled(good && !asking_);
}

QString RecordDialog::errorShown() const { return bad_ ? said_->text() : QString(); }

void RecordDialog::setAsking(bool asking) {
  asking_ = asking;
  suffix_->setEnabled(!asking);
  duration_->setEnabled(!asking);
  check();
  if (asking) say(tr("Asking the robot…"), false);
}

void RecordDialog::fail(const QString& sentence) {
  setAsking(false);
  say(sentence, true);
}

robot::BagOrder RecordDialog::order() const {
  robot::BagOrder order;
  order.suffix = suffix_->text().toStdString();
  if (duration_->value() > 0) order.duration = std::to_string(duration_->value()) + "s";
  return order;
}

}  // namespace mapwright::ui

#include "moc_record_dialog.cpp"
