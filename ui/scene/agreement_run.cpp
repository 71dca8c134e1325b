#include "scene/agreement_run.h"

#include <algorithm>

namespace mapwright::scene {
namespace {

constexpr int kTellEveryMs = 500;

}  // namespace

AgreementRun::AgreementRun(std::shared_ptr<work::Workers> workers, QObject* parent)
    : QObject(parent), most_given_out_(std::size_t(workers->threads()) * 4), tasks_(std::move(workers)) {
  since_told_.start();
}

AgreementRun::~AgreementRun() { stop(); }

std::optional<Fault> AgreementRun::setSubmaps(const std::vector<render::PlacedTexture>& submaps,
                                              int tolerance_cells) {
  agreement::Rules rules = survey_.rules();
  if (rules.tolerance_cells != tolerance_cells) {
    stop();
    rules = {.tolerance_cells = tolerance_cells};
    survey_ = agreement::Survey(rules);
  }
  std::optional<Fault> fault = survey_.setSubmaps(submaps);
  while (fault && rules.cell_m < agreement::kCoarsestCellM) {
    rules.cell_m = std::min(2 * rules.cell_m, agreement::kCoarsestCellM);
    agreement::Survey coarser(rules);
    fault = coarser.setSubmaps(submaps);
    if (fault) continue;
    stop();
    survey_ = std::move(coarser);
  }
  return fault;
}

void AgreementRun::go() {
  running_ = true;
  giveOut();
}

void AgreementRun::stop() {
  running_ = false;
  cancelled_ = true;
  tasks_.drop();
  tasks_.waitForDone();
  cancelled_ = false;
  takeOver();
  for (const auto& [generation, task] : given_out_) survey_.put(task, nullptr);
  given_out_.clear();
}

void AgreementRun::forget() {
  stop();
  survey_ = agreement::Survey();
  cache_.clear();
}

void AgreementRun::giveOut() {
  while (given_out_.size() < most_given_out_) {
    const std::optional<agreement::TileTask> next = survey_.take();
    if (!next) break;
    given_out_.emplace(next->generation, *next);
    tasks_.start(work::Urgency::Background, [this, task = *next] {
      Made made{task.generation, agreement::makeTile(task, cache_, &cancelled_)};
      const std::lock_guard lock(mutex_);
      made_.push_back(std::move(made));
      if (made_.size() == 1) QMetaObject::invokeMethod(this, &AgreementRun::collect, Qt::QueuedConnection);
    });
  }
  if (!given_out_.empty()) return;
  running_ = false;
  since_told_.start();
  Q_EMIT progressed();
}

void AgreementRun::takeOver() {
  std::vector<Made> made;
  {
    const std::lock_guard lock(mutex_);
    made.swap(made_);
  }
  for (Made& one : made) {
    const auto task = given_out_.find(one.generation);
    if (task == given_out_.end()) continue;
    survey_.put(task->second, std::move(one.tile));
    given_out_.erase(task);
  }
}

void AgreementRun::collect() {
  takeOver();
  if (!running_) return;
  giveOut();
  if (!running_ || since_told_.elapsed() < kTellEveryMs) return;
  since_told_.start();
  Q_EMIT progressed();
}

}  // namespace mapwright::scene

#include "moc_agreement_run.cpp"
