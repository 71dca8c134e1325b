// The topic by which robots list their submaps: problems with a list name it.
#pragma once

namespace mapwright::robot {

inline constexpr const char* kSubmapListTopic = "/submap_list";

}  // namespace mapwright::robot
