#pragma once

#include <string>

namespace forge {

/// Lane a (x 0 to 10) leads to connector b (10 to 20, in an intersection), which leads to lane c (a
/// quarter turn left). Only a and c list links, one each.
inline std::string tinyMap() {
  return R"({"version": "1.3",
    "node": [{"token": "n0", "x": 0, "y": -2}, {"token": "n1", "x": 10, "y": -2},
             {"token": "n2", "x": 10, "y": 2}, {"token": "n3", "x": 0, "y": 2},
             {"token": "n4", "x": 20, "y": -2}, {"token": "n5", "x": 20, "y": 2},
             {"token": "h0", "x": 1, "y": -1}, {"token": "h1", "x": 2, "y": -1},
             {"token": "h2", "x": 2, "y": 1}],
    "polygon": [{"token": "pa", "exterior_node_tokens": ["n0", "n1", "n1", "n2", "n3", "n0"],
                 "holes": []},
                {"token": "pb", "exterior_node_tokens": ["n1", "n4", "n5", "n2"], "holes": []},
                {"token": "pd", "exterior_node_tokens": ["n0", "n4", "n5", "n3"],
                 "holes": [{"node_tokens": ["h0", "h1", "h2"]}]}],
    "drivable_area": [{"token": "d", "polygon_tokens": ["pd"]}],
    "walkway": [{"token": "w", "polygon_token": "pb"}],
    "road_segment": [{"token": "r", "polygon_token": "pb", "is_intersection": true},
                     {"token": "q", "polygon_token": "pa", "is_intersection": false}],
    "lane": [{"token": "a", "polygon_token": "pa", "lane_type": "CAR"}, {"token": "c"}],
    "lane_connector": [{"token": "b", "polygon_token": "pb"}],
    "connectivity": {"a": {"incoming": [], "outgoing": ["b"]},
                     "c": {"incoming": ["b"], "outgoing": []}},
    "arcline_path_3": {
      "a": [{"start_pose": [0, 0, 0], "end_pose": [10, 0, 0], "shape": "LSR", "radius": 9,
             "segment_length": [0, 10, 0]}],
      "b": [{"start_pose": [10, 0, 0], "shape": "LSL", "radius": 9, "segment_length": [0, 10, 0]}],
      "c": [{"start_pose": [20, 0, 0], "shape": "LSL", "radius": 10.0,
             "segment_length": [15.707963267948966, 0, 0]}]}})";
}

}  // namespace forge
