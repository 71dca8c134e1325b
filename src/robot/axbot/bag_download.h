// A bag on its way into a file. On the link's thread. Source: docs/protocols/autoxing.md, "Bags".
#pragma once

#include <QString>

#include "net/http_client.h"
#include "robot/bag_library.h"
#include "robot/wire/errand.h"

namespace mapwright::robot::axbot {

/// Beside `path` first, in `path`.part, which stays when it breaks off: the next try goes on from there where
/// the robot can (206) and it is the same file by its ETag, else by its `row` in the robot's list (size and
/// end); it begins anew where not (200, 416). `http` outlives it.
void startDownload(wire::ErrandPtr errand, net::HttpClient& http, net::HttpRequest request, BagKey key,
                   std::optional<BagEntry> row, QString path, OutcomeTo<BagDownload> reply);

}  // namespace mapwright::robot::axbot
