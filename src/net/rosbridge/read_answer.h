// Answers to calls (rosbridge v2, "service_response"). Pure.
#pragma once

#include <memory>
#include <optional>

#include <QString>

#include "net/rosbridge/call_book.h"
#include "net/rosbridge/frame.h"

namespace mapwright::net::rosbridge {

/// An id as text, in whatever form the server sent it; nullopt: there is none.
std::optional<QString> idIn(const Field& id);

/// Parses the answer to a call. Its texts are plain and bounded.
CallAnswer readAnswer(const std::shared_ptr<const Frame>& frame);

}  // namespace mapwright::net::rosbridge
