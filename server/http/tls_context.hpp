#pragma once

#include <boost/asio/ssl/context.hpp>
#include <memory>

#include "server/http/server_settings.hpp"

namespace floeplan::http {

/// A context for servers: TLS 1.2 and 1.3, no compression, no renegotiation.
/// Errors   std::runtime_error that names the file: not readable, not PEM, or the key does not match the
///          certificate
[[nodiscard]] std::unique_ptr<boost::asio::ssl::context> make_tls_context(const TlsFiles& files);

}  // namespace floeplan::http
