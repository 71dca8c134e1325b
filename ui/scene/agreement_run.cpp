#include "ui/scene/agreement_run.h"

#include <algorithm>

namespace mapwright::ui::scene {
namespace {

constexpr int kTellEveryMs = 500;

}  // namespace

AgreementRun::AgreementRun(std::shared_ptr<work::Workers> workers, QObject* parent)
    : QObject(parent),
      found_(std::make_shared<agreement::Disagreement>()),
      most_given_out_(std::size_t(workers->threads()) * 4),
      tasks_(workers),
      rankers_(workers) {
  since_told_.start();
}

AgreementRun::~AgreementRun() { halt(); }

void AgreementRun::beginAnew(agreement::Survey survey) {
  halt();
  survey_ = std::move(survey);
  oldest_ = of_found_ = ++version_;
  found_ = std::make_shared<agreement::Disagreement>(agreement::disagreementOf({}, survey_.rules()));
}

std::optional<Fault> AgreementRun::setSubmaps(const std::vector<render::PlacedTexture>& submaps,
                                              int tolerance_cells) {
  agreement::Rules rules = survey_.rules();
  if (rules.tolerance_cells != tolerance_cells) {
    rules = {.tolerance_cells = tolerance_cells};
    beginAnew(agreement::Survey(rules));
  }
  const std::size_t tiles_before = survey_.tiles();
  std::optional<Fault> fault = survey_.setSubmaps(submaps);
  if (survey_.stale() > 0 || survey_.tiles() != tiles_before) ++version_;
  while (fault && rules.cell_m < agreement::kCoarsestCellM) {
    rules.cell_m = std::min(2 * rules.cell_m, agreement::kCoarsestCellM);
    agreement::Survey coarser(rules);
    fault = coarser.setSubmaps(submaps);
    if (!fault) beginAnew(std::move(coarser));
  }
  if (survey_.complete()) rank();
  return fault;
}

void AgreementRun::go() {
  running_ = true;
  giveOut();
}

void AgreementRun::stop() {
  halt();
  rank();
}

void AgreementRun::halt() {
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
  beginAnew(agreement::Survey());
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
  rank();
}

void AgreementRun::rank() {
  if (ranking_ || of_found_ == version_) return;
  ranking_ = true;
  rankers_.start(
      work::Urgency::Wanted, [this, tiles = survey_.made(), rules = survey_.rules(), version = version_] {
        auto found =
            std::make_shared<agreement::Disagreement>(agreement::disagreementOf(tiles, rules, kMostPlaces));
        const std::lock_guard lock(mutex_);
        ranked_ = {std::move(found), version};
        QMetaObject::invokeMethod(this, &AgreementRun::onRanked, Qt::QueuedConnection);
      });
}

void AgreementRun::onRanked() {
  Ranking ranked;
  {
    const std::lock_guard lock(mutex_);
    ranked = std::exchange(ranked_, {});
  }
  ranking_ = false;
  if (ranked.version >= oldest_) {
    found_ = std::move(ranked.found);
    of_found_ = ranked.version;
    Q_EMIT progressed();
  }
  if (!running_) rank();  // what came meanwhile
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
    if (survey_.put(task->second, std::move(one.tile))) ++version_;
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
  rank();
}

}  // namespace mapwright::ui::scene

#include "moc_agreement_run.cpp"
