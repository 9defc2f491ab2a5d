#include "server/http/tls_context.hpp"

#include <openssl/ssl.h>

#include <stdexcept>

#include "engine/messages/command_messages.hpp"

namespace floeplan::http {
namespace {

namespace ssl = boost::asio::ssl;

std::runtime_error fault(const char* what, const std::filesystem::path& file,
                         const boost::system::error_code& error) {
  return std::runtime_error{
      messages::command_text<"tls-file-not-usable">(what, file.string(), error.message())};
}

}  // namespace

std::unique_ptr<ssl::context> make_tls_context(const TlsFiles& files) {
  auto context = std::make_unique<ssl::context>(ssl::context::tls_server);
  SSL_CTX_set_min_proto_version(context->native_handle(), TLS1_2_VERSION);
  context->set_options(ssl::context::default_workarounds | ssl::context::no_compression |
                       SSL_OP_NO_RENEGOTIATION | SSL_OP_CIPHER_SERVER_PREFERENCE);
  // RFC 9325, 4.2: only ciphers with forward secrecy and authenticated encryption. All ciphers of TLS 1.3
  // have both.
  constexpr const char* suites = "ECDHE+AESGCM:ECDHE+CHACHA20:!aNULL:!PSK";
  if (SSL_CTX_set_cipher_list(context->native_handle(), suites) != 1)
    throw std::runtime_error{
        "the cryptographic library has none of the ciphers that TLS is spoken with here"};
  boost::system::error_code error;
  context->use_certificate_chain_file(files.certificate.string(), error);
  if (error) throw fault("certificate", files.certificate, error);
  context->use_private_key_file(files.key.string(), ssl::context::pem, error);
  if (error) throw fault("key", files.key, error);
  if (SSL_CTX_check_private_key(context->native_handle()) != 1)
    throw std::runtime_error{
        messages::command_text<"key-of-another-certificate">(files.key.string(), files.certificate.string())};
  return context;
}

}  // namespace floeplan::http
