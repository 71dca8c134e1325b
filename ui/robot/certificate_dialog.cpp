#include "ui/robot/certificate_dialog.h"

#include <QFontDatabase>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include "sentences/fault_sentence.h"
#include "ui/kit/forms.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::ui {

namespace {

constexpr qsizetype kBytesInALine = 16;

QLabel* plain(const QString& text, QWidget* parent) {
  QLabel* label = wrappedLabel(text, parent);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  label->setFocusPolicy(Qt::NoFocus);
  return label;
}

/// In two lines: 95 characters without a blank are too long for one.
QLabel* fingerprint(const QString& sha256, QWidget* parent) {
  constexpr qsizetype kInALine = kBytesInALine * 3;
  auto* label = plain(sha256.left(kInALine) + QLatin1Char('\n') + sha256.mid(kInALine), parent);
  label->setWordWrap(false);
  label->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  return label;
}

QString certificateDay(const QDateTime& time) {
  return time.isValid() ? time.toUTC().date().toString(Qt::ISODate) : QStringLiteral("?");
}

}  // namespace

CertificateDialog::CertificateDialog(const robot::UntrustedCertificate& certificate, QWidget* parent)
    : QDialog(parent),
      certificate_(certificate),
      trust_(new QPushButton(tr("Trust this certificate for this robot"), this)) {
  const bool changed = !certificate_.pinned_sha256.isEmpty();
  setWindowTitle(tr("Certificate of %1").arg(certificate_.host));
  setMinimumWidth(600);
  auto* title = plain(changed ? tr("The certificate of %1 has changed").arg(certificate_.host)
                              : tr("The certificate of %1 is not trusted").arg(certificate_.host),
                      this);
  title->setObjectName(QStringLiteral("title"));
  makeHeading(*title, 1.2);
  auto* advice = plain(
      changed ? tr("Someone may be impersonating the robot, or it was given a new certificate. Nothing has "
                   "been sent to it. Trust the new certificate only if its fingerprint matches the one that "
                   "the robot's administrator gives you.")
              : tr("No authority that this computer trusts confirms that this is the robot. Nothing has been "
                   "sent to it. Trust the certificate only if its fingerprint matches the one that the "
                   "robot's administrator gives you. From then on only this certificate is accepted."),
      this);
  advice->setObjectName(QStringLiteral("advice"));

  auto* cancel = new QPushButton(tr("Do not connect"), this);
  cancel->setObjectName(QStringLiteral("primary"));
  cancel->setDefault(true);
  trust_->setObjectName(QStringLiteral("secondary"));
  trust_->setAutoDefault(false);
  trust_->setEnabled(certificate_.trustable);
  setLayout(columnOf(
      {title, buildFacts(), advice, LayoutItem::rest(), rowOf({LayoutItem::rest(), trust_, cancel}, 8)}, 12,
      QMargins(16, 16, 16, 16)));
  connect(trust_, &QPushButton::clicked, this, &QDialog::accept);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  cancel->setFocus();
}

QWidget* CertificateDialog::buildFacts() {
  auto* box = new QWidget(this);
  auto* form = new QFormLayout(box);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(6);
  const auto row = [&](const QString& name, QLabel* value) {
    auto* label = new QLabel(name, box);
    setTextColor(*label, appColors().secondary_text);
    form->addRow(label, value);
  };
  const bool changed = !certificate_.pinned_sha256.isEmpty();
  auto* why = plain(sentences::wordsOf(certificate_.why), box);
  why->setObjectName(QStringLiteral("why"));
  setTextColor(*why, appColors().error_text);
  row(tr("Why"), why);
  row(tr("Issued for"), plain(certificate_.subject.isEmpty() ? tr("no name") : certificate_.subject, box));
  row(tr("Issued by"), plain(certificate_.issuer.isEmpty() ? tr("no name") : certificate_.issuer, box));
  row(tr("Valid"),
      plain(tr("%1 to %2").arg(certificateDay(certificate_.from), certificateDay(certificate_.until)), box));
  if (changed) row(tr("Trusted until now (SHA-256)"), fingerprint(certificate_.pinned_sha256, box));
  row(changed ? tr("Now (SHA-256)") : tr("Fingerprint (SHA-256)"), fingerprint(certificate_.sha256, box));
  return box;
}

}  // namespace mapwright::ui

#include "moc_certificate_dialog.cpp"
