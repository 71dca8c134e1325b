// How a session with a robot lies in an MCAP file: what is written by mapwright, and what a player may rely
// on. Pure, any thread. Written as MCAP, version 0 (recording::McapWriter), profile empty, library
// "mapwright".
//
// Metadata "mapwright" (kAbout): version, address (never with a secret), kind (the scheme of the address:
// "axbot", "aimdk", "ros", "kabam", "file"; "demo" is an Autoxing robot), model, serial, name, firmware (each
// empty where the robot did not say), recorded_by ("mapwright 1.2.3"), started_ns. It is written again when a
// robot says only later who it is: the last one counts. Metadata "mapwright.end" (kEnd), once, when the
// recording was finished: ended_ns, messages, lost (messages and files that were not written because the disk
// or this computer was too slow), lost_bytes. A file without it was interrupted. Metadata
// "mapwright.repaired" instead of it: what is sound of one that was interrupted, made a whole file since;
// broke_off_ns is the time of the last message (absent without one). Metadata "mapwright.link" (kLink): the
// link to the robot was away. lost_ns when it was lost, and once more with back_ns when it was there again;
// without that it was away to the end.
//
// Messages. Log time: when the message arrived here, nanoseconds since 1970 (UTC) of this computer's clock,
// never less than started_ns. Publish time: the robot's own stamp where the message has one, else the log
// time. Sequence: counts the messages of the topic from 1, those that were lost included: a gap is a loss.
// Every channel has a schema, and others can read it: where nothing better is known it is the JSON schema
// {"type":"object"} (schema name "mapwright.Message", kPlainJson, unless another one is said below).
//   Autoxing, text frames: topic = the frame's own, message_encoding "json", the frame exactly as sent.
//   Frames
//     without a topic (answers, errors): topic "/axbot/answer".
//   Autoxing, binary frames: topic as the frame says ("/axbot/binary" where it says none), message_encoding
//     "protobuf", schema "ros_messages.RosMessageWrapper" with its definition: what the frame holds behind
//     its topic and its gzip flag, unpacked (docs/protocols/autoxing.md, "Binary frames"). One that cannot be
//     unpacked: message_encoding "json", schema name "mapwright.axbot.BinaryFrame", {"base64": the frame as
//     sent}.
//   ROS: topic = the topic, schema_name = its ROS type as the server writes it. Where rosapi tells what the
//     type is made of: message_encoding "ros1" with schema_encoding "ros1msg", or "cdr" with "ros2msg", the
//     message as ROS itself writes it. Where it does not, or where a message is not what its definition says:
//     "json", the member `msg` as sent, or as JSON where it came as CBOR; of a type that nobody said the
//     schema name is kPlainJson. An asked map: topic = the service ("/static_map"), schema_name
//     "nav_msgs/GetMapResponse", the member `values` likewise.
//   AimDK: topic "/aimdk/CALL" (CALL without its service: "GetStoredMapNames", "GetCurrentWorkingMap",
//     "GetTopoMsgs"), message_encoding "json", the body of the answer as sent. Get2DWholeMap is an
//     attachment. What the rosbridge beside it says is written as that of a ROS robot.
// Until version 1 of the layout messages of ROS were "json" or "cbor" with a schema without encoding and
// data, binary frames "protobuf" with the frame as sent and a schema "mapwright.axbot.BinaryFrame" likewise.
//
// What was said before the recording began. The first messages are the last one of every topic that had been
// said by then (as far as memory went): log time started_ns, publish time as above but the time of its own
// arrival where the robot gave none. They are on channels of their own, which have the topic, encodings and
// schema of the later ones and the channel metadata said=before (kSaid, kBefore). Several messages of a topic
// may be among them: /tf_static has one for each set of child frames. Their sequence is 0.
// A part that is cut out of a recording begins with all that still counts then: markers that last, static
// transforms, patches, the transforms of the last ten seconds and those by which something earlier was
// placed. Its channels also have the metadata said_at=publish_time (kSaidAt, kPublishTime): the publish time
// is the log time that the message had in the whole, and with lifetimes and transforms it counts as said
// then.
//
// Attachments. Each once; one whose content has changed comes again under the same name with a later log
// time: at a time T the last one that is not later than T counts, or else the first. Log time: when it was
// fetched (started_ns, where that was before).
//   submaps/UUID/TRAJECTORY/INDEX/VERSION   the answer's body, "application/x-protobuf"
//                                           (docs/protocols/cartographer-submaps.md, "Messages"); VERSION is
//                                           what the answer says of itself
//   maps/KIND/ID                            the picture of a whole map, its own media type
//   maps/KIND/ID.json                       what belongs to it, see below
//   pictures/URL                            the picture that a message only names, URL exactly as the message
//                                           has it (data_url, url)
//   waypoints/KIND/ID.json                  its named places and overlays, see below
// KIND: "live", "stored", "mapping", "file". UUID and ID are percent-encoded (RFC 3986: all but A-Z a-z 0-9 -
// . _ ~); an empty ID is "-".
//
// maps/….json:
// {"kind","id","name","uid"?,"map_version"?,"current":bool,"grid":{"width","height","resolution_m","x_m","y_m",
// "yaw_rad"},"reading":{"mode":"picture"|"trinary"|"scale"|"raw","negate","occupied_thresh","free_thresh"},
// "fingerprint","display_rotation_rad"?,"trajectories":[[[x,y],…],…],"landmarks":[{"id","x_m","y_m"},…]}.
// The pose in "grid" is that of the picture's lower left corner in the world.
// waypoints/….json: {"kind","id","waypoints":[{"id","name","type","x_m","y_m","yaw_rad"?,"tags":[…],
// "source"?},…],"overlays":[{"shape":"point"|"line"|"polygon","type","id","name","yaw_rad"?,
// "parts":[[[x,y],…],…]},…]}. Members as in map::Waypoint and map::OverlayFeature.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "map/catalogue.h"
#include "map/submap.h"
#include "map/waypoint.h"

namespace mapwright::recorder {

inline constexpr int kVersion = 2;
inline constexpr const char* kAbout = "mapwright";
inline constexpr const char* kEnd = "mapwright.end";
inline constexpr const char* kRepaired = "mapwright.repaired";
inline constexpr const char* kLink = "mapwright.link";
inline constexpr const char* kSaid = "said";  // channel metadata
inline constexpr const char* kBefore = "before";
inline constexpr const char* kSaidAt = "said_at";  // channel metadata, beside kSaid
inline constexpr const char* kPublishTime = "publish_time";
inline constexpr const char* kAxbotAnswer = "/axbot/answer";
inline constexpr const char* kAxbotBinary = "/axbot/binary";
inline constexpr const char* kAxbotBinarySchema = "mapwright.axbot.BinaryFrame";
inline constexpr const char* kPlainJson = "mapwright.Message";

/// "submaps/UUID/TRAJECTORY/INDEX/VERSION".
std::string submapName(const map::SubmapKey& key);
/// The reverse; nullopt for all other names.
std::optional<map::SubmapKey> submapFrom(std::string_view name);

/// "maps/KIND/ID", "maps/KIND/ID.json", "waypoints/KIND/ID.json".
std::string mapName(const map::MapKey& key);
std::string mapFactsName(const map::MapKey& key);
std::string waypointsName(const map::MapKey& key);
/// Parses "maps/KIND/ID"; nullopt for all other names, including "….json".
std::optional<map::MapKey> mapFrom(std::string_view name);

/// "pictures/URL".
std::string pictureName(std::string_view url);

/// The JSON attachments. `current`: the robot uses the map. `entry`: its catalogue entry, as far as the robot
/// reported it; messages refer to maps by its uid.
std::string mapFacts(const map::WholeMap& map, bool current, const map::CatalogueEntry& entry = {});
std::string placesText(const map::MapKey& key, const map::WaypointList& places,
                       const std::vector<map::OverlayFeature>& overlays);

}  // namespace mapwright::recorder
