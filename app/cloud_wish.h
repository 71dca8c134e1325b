// The part of the map's cloud that a snapshot shows.
#pragma once

#include <memory>
#include <optional>

#include <QString>

#include "clouds/cloud_store.h"
#include "geometry/rect.h"
#include "session/session.h"

namespace mapwright::app {

class CloudWish {
 public:
  /// The session outlives this.
  explicit CloudWish(session::Session& session) : session_(session) {}

  /// Requests the points over this part of the plane, at any height; only once.
  void ask(const geometry::WorldRect& seen);
  bool asked() const { return asked_; }
  /// True when it has arrived or cannot be loaded.
  bool in() const { return answer_->came.has_value() || !answer_->problem.isEmpty(); }
  const std::optional<clouds::CloudPiece>& came() const { return answer_->came; }
  /// Why it cannot be loaded, as a sentence; empty = nothing is known to be wrong.
  QString problem() const { return answer_->problem; }

 private:
  struct Answer {
    std::optional<clouds::CloudPiece> came;
    QString problem;
  };
  session::Session& session_;
  bool asked_ = false;
  std::shared_ptr<Answer> answer_ = std::make_shared<Answer>();  // may arrive after this object is gone
};

}  // namespace mapwright::app
