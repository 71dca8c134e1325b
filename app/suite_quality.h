// Looks into the SLAM session behind a view (docs/maps-in-ci.md, "Is the map still good?").
#pragma once

#include <functional>
#include <memory>

#include <QObject>

#include "render/dense_cache.h"
#include "session/session.h"
#include "suite/quality.h"
#include "work/workers.h"

namespace mapwright::app {

struct ExaminingMeans {
  std::shared_ptr<work::Workers> workers;
  std::shared_ptr<render::DenseCache> dense;
  double timeout_s = 60;  // to compare the submaps
};

/// What `asked` needs of a session that stands still. `done` is called once, on this thread: at once, or
/// while the event loop runs and `context` and `session` live. Submaps are compared on other threads
/// meanwhile.
void examine(const suite::Quality& asked, const session::Session& session, const ExaminingMeans& means,
             QObject* context, std::function<void(suite::Examined)> done);

}  // namespace mapwright::app
