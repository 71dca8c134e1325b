#include "robot/axbot/grid_fetcher.h"

#include "robot/axbot/faults.h"
#include "robot/wire/picture_bytes.h"

namespace mapwright::robot::axbot {

void GridFetcher::fetch(GridToFetch wanted) {
  const auto under_way = jobs_.find(wanted.grid.topic);
  if (under_way != jobs_.end()) {
    under_way->second.next = std::move(wanted);
  } else {
    start(wanted);
  }
}

void GridFetcher::start(const GridToFetch& wanted) {
  const QUrl url = robotUrl(server_.base, wanted.data_url);
  if (!url.isValid()) {
    take_(map::UnreadableMessage{
        wanted.grid.topic, Fault(fault::PictureAddressInvalid).followedBy(Consequence::PictureBeforeStays)});
    return;
  }
  jobs_[wanted.grid.topic].request =
      server_.http.send(server_.pictureRequest(url),
                        [this, wanted, url](const net::HttpAnswer& answer) { finish(wanted, url, answer); });
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
  if (answer.ok()) server_.http.discard(url);
  const Fault why = answer.ok() ? Fault(fault::AnswerIsEmpty) : answer.reason;
  take_(map::UnreadableMessage{
      grid.topic,
      {fault::PictureNotHad, {url.path().left(120).toStdString()}, {why}, Consequence::PictureBeforeStays}});
}

void GridFetcher::discardPicture(const std::string& fingerprint) {
  if (const QUrl url = origins_.find(fingerprint); url.isValid()) server_.http.discard(url);
}

void GridFetcher::cancelAll() {
  for (const auto& [topic, job] : jobs_) server_.http.cancel(job.request);
  jobs_.clear();
}

}  // namespace mapwright::robot::axbot
