// Definitions as ROS 2 writes them in IDL. Apart from the test: moc does not get along with them.
#pragma once

#include <string>

namespace idl_sample {

inline const std::string kThing = R"(IDL: a_msgs/msg/Thing
// generated from rosidl_adapter/resource/msg.idl.em
#include "a_msgs/msg/Part.idl"
#include "std_msgs/msg/Header.idl"

module a_msgs {
  module msg {
    typedef double double__36[36];
    typedef a_msgs::msg::Part a_msgs__msg__Part__2[2];
    module Thing_Constants {
      const uint8 UNKNOWN = 0;
      @verbatim (language="comment", text=
        "A text with ) and ; and \" in it" "\n" "more")
      const string NAME = "x;}";
      const unsigned long COUNT = 3;
    };
    /* a comment
       of two lines */
    @verbatim (language="comment", text=
      "What it is.")
    struct Thing {
      std_msgs::msg::Header header;
      @default (value=7)
      uint8 level;
      @unit (value="m")
      double__36 covariance;
      a_msgs__msg__Part__2 pair;
      sequence<a_msgs::msg::Part> parts;
      sequence<float, 5> floats;
      string<10> name;
      sequence<string<4>, 3> names;
      long long large;
      unsigned short s, t;
      boolean yes;
      octet raw[Thing_Constants::COUNT];
      sequence<octet> bytes;
    };
  };
};
)";

inline const std::string kPart = R"(IDL: a_msgs/msg/Part
module a_msgs { module msg { struct Part { float x; int8 kind; Empty nothing; };
  struct Empty { uint8 structure_needs_at_least_one_member; }; }; };
)";

inline const std::string kHeader = R"(IDL: std_msgs/msg/Header
#include "builtin_interfaces/msg/Time.idl"
module std_msgs { module msg { struct Header { builtin_interfaces::msg::Time stamp; string frame_id; }; }; };
)";

}  // namespace idl_sample
