// The signals of a submission, independent of what it sends.
#pragma once

#include <QObject>

namespace mapwright::edit {

class SubmissionEvents : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

 Q_SIGNALS:
  void changed();  // its phase, or the state of a request
};

}  // namespace mapwright::edit
