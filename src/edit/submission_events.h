// What a submission tells, whatever it sends.
#pragma once

#include <QObject>

namespace mapwright::edit {

class SubmissionEvents : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

 Q_SIGNALS:
  void changed();  // its phase, or how a request stands
};

}  // namespace mapwright::edit
