// Asks whether to trust a certificate that no authority confirms.
#pragma once

#include <QDialog>

#include "robot/robot.h"

class QPushButton;

namespace mapwright::ui {

/// Accepted: trust exactly this certificate, for this robot.
class CertificateDialog : public QDialog {
  Q_OBJECT
 public:
  explicit CertificateDialog(const robot::UntrustedCertificate& certificate, QWidget* parent = nullptr);
  const robot::UntrustedCertificate& certificate() const { return certificate_; }
  QPushButton* trustButton() const { return trust_; }

 private:
  QWidget* buildFacts();

  robot::UntrustedCertificate certificate_;
  QPushButton* trust_;
};

}  // namespace mapwright::ui
