// The functions of Boost.Asio and Boost.Beast that need be compiled once only (their separate compilation).
#include <boost/asio/impl/src.hpp>
#include <boost/beast/src.hpp>
