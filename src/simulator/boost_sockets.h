// Boost's sockets, only for the sources that are compiled with them (CMakeLists.txt). One executor type and
// one handler type per operation, since Boost instantiates everything for each combination.
#pragma once

#include <functional>

#include <boost/asio/basic_waitable_timer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>

namespace mapwright::simulator {

using Executor = boost::asio::io_context::executor_type;
using Socket = boost::asio::basic_stream_socket<boost::asio::ip::tcp, Executor>;
using Stream = boost::beast::basic_stream<boost::asio::ip::tcp, Executor>;
using Clock = std::chrono::steady_clock;
using Timer = boost::asio::basic_waitable_timer<Clock, boost::asio::wait_traits<Clock>, Executor>;
using HttpParser = boost::beast::http::request_parser<boost::beast::http::string_body>;

using ErrorCode = boost::beast::error_code;
using Transferred = std::function<void(ErrorCode, std::size_t)>;
using Waited = std::function<void(ErrorCode)>;

struct Connection {
  Socket socket;
};
struct Handshake {
  HttpParser::value_type request;
};

void readHttp(Stream& stream, boost::beast::flat_buffer& buffer, HttpParser& parser, Transferred done);
void shutDown(Stream& stream);

}  // namespace mapwright::simulator
