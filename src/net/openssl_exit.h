// OpenSSL, which Qt loads for encrypted connections, must not tidy up while threads are still ending.
#pragma once

namespace mapwright::net {

/// Keeps OpenSSL from freeing its memory when the program exits. Qt says that a thread has ended while the C
/// library is still freeing what OpenSSL keeps for it; if the program exits just then, both free the same
/// block, and the program is ended by a damaged heap. Call it before anything may load OpenSSL; only the
/// first call does something. Any thread. Source: OPENSSL_init_crypto(3), OPENSSL_INIT_NO_ATEXIT.
void keepOpensslAtExit();

}  // namespace mapwright::net
