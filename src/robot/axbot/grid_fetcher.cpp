#include "robot/axbot/grid_fetcher.h"

#include "robot/axbot/faults.h"
#include "robot/axbot/robot_urls.h"
#include "robot/wire/picture_facts.h"

namespace mapwright::robot::axbot {

GridFetcher::GridFetcher(net::HttpClient& http, QUrl base, Take take)
    : http_(http), base_(std::move(base)), take_(std::move(take)) {}

void GridFetcher::fetch(GridToFetch wanted) {
  const auto under_way = jobs_.find(wanted.grid.topic);
  if (under_way != jobs_.end()) {
    under_way->second.next = std::move(wanted);
  } else {
    start(wanted);
  }
}

void GridFetcher::start(const GridToFetch& wanted) {
  net::HttpRequest request;
  request.url = robotUrl(base_, wanted.data_url);
  if (!request.url.isValid()) {
    take_(map::UnreadableMessage{
        wanted.grid.topic, Fault(fault::PictureAddressInvalid).followedBy(Consequence::PictureBeforeStays)});
    return;
  }
  request.accept = "image/png,image/*;q=0.8,*/*;q=0.5";
  request.cacheable = true;
  jobs_[wanted.grid.topic].request = http_.send(
      request,
      [this, wanted, url = request.url](const net::HttpAnswer& answer) { finish(wanted, url, answer); });
}

void GridFetcher::finish(const GridToFetch& wanted, const QUrl& url, const net::HttpAnswer& answer) {
  const map::GridMessage& grid = wanted.grid;
  if (answer.kind == net::HttpAnswer::Kind::Cancelled) return;
  auto job = jobs_.extract(grid.topic);
  if (!job.empty() && job.mapped().next) start(*job.mapped().next);
  if (answer.ok() && !answer.body.isEmpty()) {
    map::GridMessage complete = grid;
    complete.png = std::make_shared<const std::string>(answer.body.toStdString());
    complete.fingerprint = wire::fingerprint(*complete.png);
    complete.body_bytes = std::size_t(answer.body.size());
    complete.from_cache = answer.from_cache;
    origins_.note(complete.fingerprint, url);
    if (keep_) keep_(grid.topic, wanted.data_url, "image/png", complete.png);
    take_(std::move(complete));
    return;
  }
  if (answer.ok()) http_.discard(url);
  const Fault why = answer.ok() ? Fault(fault::AnswerIsEmpty) : answer.reason;
  take_(map::UnreadableMessage{
      grid.topic,
      {fault::PictureNotHad, {url.path().left(120).toStdString()}, {why}, Consequence::PictureBeforeStays}});
}

void GridFetcher::discardPicture(const std::string& fingerprint) {
  if (const QUrl url = origins_.find(fingerprint); url.isValid()) http_.discard(url);
}

void GridFetcher::cancelAll() {
  for (const auto& [topic, job] : jobs_) http_.cancel(job.request);
  jobs_.clear();
}

}  // namespace mapwright::robot::axbot
