// Downloads a bag to a file. On the link's thread. Source: docs/protocols/autoxing.md, "Bags".
#pragma once

#include <QString>

#include "net/http_client.h"
#include "robot/bag_library.h"
#include "robot/wire/errand.h"

namespace mapwright::robot::axbot {

/// First to `path`.part, which stays after an interruption: the next attempt resumes there if the robot
/// supports it (206) and the file is the same by its ETag, or by its `row` in the robot's list (size and
/// end); otherwise it starts over (200, 416). `http` outlives it.
void startDownload(wire::ErrandPtr errand, net::HttpClient& http, net::HttpRequest request, BagKey key,
                   std::optional<BagEntry> row, QString path, OutcomeTo<BagDownload> reply);

}  // namespace mapwright::robot::axbot
