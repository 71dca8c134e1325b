// How maps and their pictures are written into answers.
#pragma once

#include <string>
#include <string_view>

#include "simulator/fault_plan.h"
#include "simulator/http_answer.h"
#include "simulator/map_library.h"

namespace mapwright::simulator {

/// A map's PNG with the effects of the faults.
std::string faultyPng(const std::string& png, const Faults& faults);

/// 404 if there is none, 304 if the client has it.
HttpAnswer pictureAnswer(const MapPicturePtr& picture, const HttpQuestion& question, bool for_ever,
                         const Faults& faults);
/// Bytes that a client may cache by their tag.
HttpAnswer bytesAnswer(std::shared_ptr<const std::string> bytes, const HttpQuestion& question);
/// The binary map for an uploaded or drawn picture, used for localization.
std::shared_ptr<const std::string> pbstreamOf(const MapPicturePtr& picture);

/// The common members of all answers about a map.
Value mapValue(const StoredMap& map);
/// Adds grid_origin_x, grid_origin_y and grid_resolution; zeros without a picture.
void addGrid(Value& value, const MapPicturePtr& picture);
/// One row of the list of maps.
Value mapRow(const StoredMap& map);

}  // namespace mapwright::simulator
