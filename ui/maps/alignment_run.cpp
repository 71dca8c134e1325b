#include "ui/maps/alignment_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <QElapsedTimer>

#include "align/align_placed.h"
#include "cells/cell_texture.h"
#include "render/compose_grid.h"
#include "render/dense_cache.h"

namespace mapwright::ui {
namespace {

constexpr double kComposePart = 0.2;

/// What submaps are composed in: finer than what maps are aligned in is of no use.
double cellOf(const std::vector<render::PlacedTexture>& submaps) {
  constexpr double kFinest_m = 0.05;
  double finest = std::numeric_limits<double>::infinity();
  for (const render::PlacedTexture& placed : submaps) {
    if (placed.texture->resolutionM() > 0) finest = std::min(finest, placed.texture->resolutionM());
  }
  return std::isfinite(finest) ? std::max(kFinest_m, finest) : kFinest_m;
}

}  // namespace

AlignmentRun::AlignmentRun(std::shared_ptr<work::Workers> workers, QObject* parent)
    : QObject(parent), workers_(std::move(workers)), share_(workers_) {}

AlignmentRun::~AlignmentRun() { cancel(); }

void AlignmentRun::cancel() {
  cancelled_->store(true);
  running_ = false;
}

void AlignmentRun::start(render::PlacedGrid old_map, NewMap new_map, std::vector<placing::PointPair> pairs) {
  cancel();
  cancelled_ = std::make_shared<std::atomic<bool>>(false);
  running_ = true;
  share_.startLong([this, cancelled = cancelled_, old_map = std::move(old_map), new_map = std::move(new_map),
                    pairs = std::move(pairs), workers = workers_] {
    // Unless it is cancelled meanwhile.
    const auto tell = [this, cancelled](auto what) {
      QMetaObject::invokeMethod(
          this,
          [cancelled, what = std::move(what)] {
            if (!*cancelled) what();
          },
          Qt::QueuedConnection);
    };
    QElapsedTimer told;
    const auto proceed = [&](double done) {
      if (!told.isValid() || told.elapsed() > 50) {
        told.start();
        tell([this, done] { Q_EMIT progressed(done); });
      }
      return !cancelled->load();
    };
    const auto* const submaps = std::get_if<std::vector<render::PlacedTexture>>(&new_map);
    render::PlacedGrid on;
    if (submaps) {
      render::DenseCache cache;
      const auto composed =
          render::composeGrid(*submaps, cellOf(*submaps), cache,
                              [&](double done) { return proceed(done * kComposePart); }, {workers});
      if (!composed) {
        return tell([this, fault = composed.error()] {
          running_ = false;
          Q_EMIT failed(fault);
        });
      }
      on = {composed->cells, composed->reference};
    } else {
      on = std::get<render::PlacedGrid>(new_map);
    }
    const double from = submaps ? kComposePart : 0;
    const auto found = align::alignPlaced(
        old_map, on, {pairs, workers, [&](double done) { return proceed(from + (1 - from) * done); }},
        cancelled.get());
    if (!found) return;
    tell([this, found = *found] {
      running_ = false;
      Q_EMIT finished(found);
    });
  });
}

}  // namespace mapwright::ui

#include "moc_alignment_run.cpp"
