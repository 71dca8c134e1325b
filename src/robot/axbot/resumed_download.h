// A file of an Autoxing robot that goes to the disk, and goes on after an interruption. Lives on the link's
// thread. Source: docs/protocols/autoxing.md, "Bags", "Requests".
#pragma once

#include <cstdint>
#include <optional>

#include <QByteArray>
#include <QString>

#include "map/subject.h"
#include "net/http_client.h"
#include "robot/call.h"
#include "robot/wire/task.h"

namespace mapwright::robot::axbot {

struct DownloadOrder {
  net::HttpRequest request;
  map::Subject subject;
  QString path;
  QByteArray identity;                     // of the content, as the robot tells it elsewhere; empty = unknown
  std::optional<std::int64_t> told_bytes;  // its size, likewise: less than that is not the whole
  bool exactly = false;                    // nor is more
};

struct ResumedDownload {
  std::int64_t bytes = 0;
  bool resumed = false;
};

/// First to `path`.part, with what it is a part of in `path`.part.of, then renamed. Both stay after an
/// interruption: the next attempt resumes there if the robot supports it (206) and the content is the same by
/// its ETag, or by `identity`; otherwise it starts over (200, 416).
void downloadResumed(const wire::TaskPtr& task, net::HttpClient& http, DownloadOrder order,
                     OutcomeTo<ResumedDownload> reply);

}  // namespace mapwright::robot::axbot
