#include "disk/fault.h"

#include <cstring>

namespace mapwright::disk {

Fault systemFault(std::string path, int error) {
  Fault fault;
  fault.path = std::move(path);
  fault.system = std::strerror(error);
  return fault;
}

}  // namespace mapwright::disk
