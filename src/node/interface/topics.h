// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// Topics and services: name, type, and when messages are sent or what the service does.
#pragma once

#include <array>
#include <string>

namespace link_bounds {

struct TopicName {
  const char* name;
  const char* type;
  const char* when;
};

/// The name without its ~, as a private NodeHandle expects it.
inline std::string privateName(const TopicName& topic) {
  return topic.name + 1;
}

constexpr TopicName kBoxesTopic{
    "~boxes", "link_bounds/AxisAlignedBoxArray",
    "with each tf message that brings a new pose or stamp of a bounded link, and whenever an "
    "object or incomplete changes; under load, one message answers several of tf; limited by "
    "max_rate; latched"};
constexpr TopicName kGroupsTopic{"~groups", "link_bounds/AxisAlignedBoxArray",
                                 "with each ~boxes: box robot, then one per groups entry with a "
                                 "box, in alphabetical order; latched"};
constexpr TopicName kMarkersTopic{
    "~markers", "visualization_msgs/MarkerArray",
    "all boxes, at most marker_rate, only while somebody listens; a new subscriber gets all at "
    "once"};
constexpr TopicName kPartsTopic{
    "~parts", "link_bounds/AxisAlignedBoxArray",
    "several boxes of one name, which together cover the link; with each ~boxes, or the newest one "
    "where computing takes longer; only while somebody listens and parts_per_link > 1; when "
    "parts_per_link becomes 1, one empty message; a new subscriber gets all at once"};
constexpr TopicName kFootprintTopic{
    "~footprint", "geometry_msgs/Polygon",
    "with each ~groups, only while somebody listens and box robot is complete: its rectangle in x "
    "and y of the fixed frame, rounded outward, without the links that /diagnostics calls left "
    "out; a new subscriber gets one at once"};
constexpr TopicName kOverlapsTopic{
    "~overlaps", "link_bounds/BoxOverlapArray",
    "also when empty; with each ~boxes, or the newest one where computing takes longer; only while "
    "somebody listens; a new subscriber gets one at once"};
constexpr TopicName kDistancesTopic{
    "~distances", "link_bounds/DistanceArray",
    "pairs of bodies with distance <= distance_limit, at most the max_pairs nearest of them, also "
    "when empty; with each ~boxes, or the newest one where computing takes longer; only while "
    "somebody listens; sent at once when somebody subscribes, and again when triangles have been "
    "loaded"};
constexpr TopicName kNearestTopic{
    "~nearest", "link_bounds/Distance",
    "with each ~distances: the pair of the smallest distance; if no pair is near, names are empty "
    "and both distances equal distance_limit"};
constexpr TopicName kDistanceMarkersTopic{
    "~distance_markers", "visualization_msgs/MarkerArray",
    "at most marker_rate, only while somebody listens: a line per pair of ~distances, and the "
    "smallest distance as text"};
constexpr TopicName kSweptTopic{
    "~swept", "link_bounds/AxisAlignedBoxArray",
    "what ~get_boxes gives for the last swept_span seconds; with each ~boxes, or the newest one "
    "where computing takes longer; only while somebody listens and swept_span > 0; sent at once "
    "when somebody subscribes"};
constexpr TopicName kSweptMarkersTopic{"~swept_markers", "visualization_msgs/MarkerArray",
                                       "the boxes of ~swept, at most marker_rate, only while "
                                       "somebody listens and swept_span > 0"};
constexpr TopicName kStoppingTopic{
    "~stopping", "link_bounds/AxisAlignedBoxArray",
    "boxes around all that links can reach until the robot stands; with each ~boxes, or the newest "
    "one where computing takes longer; only while somebody listens; sent at once when somebody "
    "subscribes"};
constexpr TopicName kStoppingMarkersTopic{
    "~stopping_markers", "visualization_msgs/MarkerArray",
    "the boxes of ~stopping, at most marker_rate, only while somebody listens"};
constexpr TopicName kStoppingOverlapsTopic{
    "~stopping_overlaps", "link_bounds/BoxOverlapArray",
    "pairs of boxes of ~stopping, by the rules of ~overlaps, also when empty; as ~stopping, only "
    "while somebody listens"};
constexpr TopicName kEarliestTopic{
    "~earliest", "link_bounds/EarliestContactArray",
    "how soon links and objects that stand can touch, whatever the controllers do; with each "
    "~boxes, or the newest one where computing takes longer; only while somebody listens; sent at "
    "once when somebody subscribes"};
constexpr TopicName kDiagnosticsTopic{"/diagnostics", "diagnostic_msgs/DiagnosticArray",
                                      "every second of wall time"};
constexpr TopicName kObjectsTopic{"~objects", "visualization_msgs/MarkerArray",
                                  "subscribed; each marker becomes a box"};
constexpr TopicName kObjectTopic{"~object", "visualization_msgs/Marker",
                                 "subscribed; one marker, as those of ~objects"};
constexpr TopicName kNeighboursTopic{
    "~neighbours", "link_bounds/AxisAlignedBoxArray",
    "subscribed, tcpNoDelay; ~boxes of other nodes, each box becomes an object NODE/NAME"};
constexpr TopicName kJointStatesTopic{
    "joint_states", "sensor_msgs/JointState",
    "subscribed if the parameter joint_states is set, while somebody listens to ~stopping or "
    "~earliest"};
constexpr TopicName kTfTopic{"/tf", "tf2_msgs/TFMessage", "subscribed, tcpNoDelay"};
constexpr TopicName kTfStaticTopic{"/tf_static", "tf2_msgs/TFMessage", "subscribed, tcpNoDelay"};

constexpr std::array<TopicName, 22> kTopics{{kBoxesTopic,
                                             kGroupsTopic,
                                             kMarkersTopic,
                                             kPartsTopic,
                                             kFootprintTopic,
                                             kOverlapsTopic,
                                             kDistancesTopic,
                                             kNearestTopic,
                                             kDistanceMarkersTopic,
                                             kSweptTopic,
                                             kSweptMarkersTopic,
                                             kStoppingTopic,
                                             kStoppingMarkersTopic,
                                             kStoppingOverlapsTopic,
                                             kEarliestTopic,
                                             kDiagnosticsTopic,
                                             kTfTopic,
                                             kTfStaticTopic,
                                             kJointStatesTopic,
                                             kObjectsTopic,
                                             kObjectTopic,
                                             kNeighboursTopic}};

constexpr TopicName kReloadService{
    "~reload", "std_srvs/Trigger",
    "reads robot_description and all parameters again and answers after the swap, with the "
    "warnings that it logs; on failure keeps the old model and says why"};
constexpr TopicName kGetBoxesService{
    "~get_boxes", "link_bounds/GetBoxes",
    "boxes at a time within tf's 10 s of history, or around everything between two times, in any "
    "frame; of those in names, or of all links and objects"};

constexpr TopicName kCheckPathService{"~check_path", "link_bounds/CheckPath",
                                      "whether the robot collides along a trajectory, with itself "
                                      "or with objects, proven also between "
                                      "the way points; other joints rest where tf has them"};

constexpr std::array<TopicName, 3> kServices{{kReloadService, kGetBoxesService, kCheckPathService}};

}  // namespace link_bounds
