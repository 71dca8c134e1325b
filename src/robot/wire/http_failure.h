// What became of an HTTP request, in the words of the port. Pure.
#pragma once

#include "map/problem.h"
#include "net/http_client.h"
#include "robot/robot.h"

namespace mapwright::robot::wire {

/// None for a 2xx; 401 and 403 are refusals like those of the link itself.
map::FailureKind failureOf(const net::HttpAnswer& answer);
/// Of an answer that came (2xx) but cannot be read: a web page is not what a robot sends.
map::FailureKind unreadable(const net::HttpAnswer& answer);

/// The same certificate in the words of the port.
UntrustedCertificate untrusted(const net::CertificateFault& fault);

}  // namespace mapwright::robot::wire
