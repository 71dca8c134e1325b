#include "simulator/ros/garbage.h"

#include "simulator/fault_plan.h"

namespace mapwright::simulator::ros {

Garbage garbageOf(std::size_t number) {
  switch (number % 16) {
    case 0:
      return {"this is no JSON"};
    case 1:
      return {R"({"op":"publish","topic":"/map","msg":{"info":{"width":)"};
    case 2:
      return {garbage(number), true};
    case 3:
      return {R"({"op":"no such op","id":7})"};
    case 4:
      return {R"({"op":"publish","topic":"/map"})"};
    case 5:
      return {R"({"op":"publish","topic":17,"msg":[]})"};
    case 6:
      return {R"({"op":"service_response","id":"never asked","service":"/x","values":{},"result":true})"};
    case 7:
      return {std::string(2000, '[')};
    case 8:
      return {R"({"op":"fragment","id":0,"data":"{\"op\":","num":5,"total":2.5})"};
    case 9:
      return {R"({"op":"png","data":"iVBORw0KGgo*** this is no base64 ***"})"};
    case 10:
      return {"[1,2,3]"};
    case 11:
      return {std::string("\xBF\x62op", 4), true};  // CBOR that ends too early
    case 12:
      return {std::string("\xD8\x48\x5B\x7F\xFF\xFF\xFF\xFF\xFF\xFF\xFF", 11), true};  // and one that lies
    case 13:
      return {R"({"op":"service_response","values":null})"};
    case 14:
      return {R"({"op":"publish","topic":"/scan","msg":{"ranges":[NaN,Infinity],"header":null}})"};
    default:
      return {""};
  }
}

}  // namespace mapwright::simulator::ros
