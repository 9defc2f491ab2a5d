#pragma once

// clang-format off: Asio's awaitable uses std::exchange, but does not include it
#include <utility>
// clang-format on

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/associated_executor.hpp>
#include <boost/beast/core/error.hpp>
#include <cstddef>
#include <memory>

namespace floeplan::http {

/// What is called once some bytes have been read or written, whatever its type: sockets and TLS are compiled for this one
/// handler, not again for each operation that Beast puts together of them.
/// Threads  runs on the executor that the handler was given for
class Completion {
 public:
  using executor_type = boost::asio::any_io_executor;

  template <class Handler>
  Completion(Handler handler, const executor_type& otherwise)
      : executor_{boost::asio::get_associated_executor(handler, otherwise)},
        handler_{std::make_unique<Held<Handler>>(std::move(handler))} {}

  [[nodiscard]] executor_type get_executor() const noexcept { return executor_; }

  void operator()(boost::beast::error_code error, std::size_t bytes) {
    const std::unique_ptr<Base> handler = std::move(handler_);  // it may end what holds this
    handler->call(error, bytes);
  }

 private:
  struct Base {
    Base() = default;
    Base(const Base&) = delete;
    Base& operator=(const Base&) = delete;
    virtual ~Base() = default;
    virtual void call(boost::beast::error_code error, std::size_t bytes) = 0;
  };
  template <class Handler>
  struct Held final : Base {
    explicit Held(Handler&& handler) : handler_{std::move(handler)} {}
    void call(boost::beast::error_code error, std::size_t bytes) override {
      Handler handler = std::move(handler_);
      std::move(handler)(error, bytes);
    }
    Handler handler_;
  };

  executor_type executor_;
  std::unique_ptr<Base> handler_;
};

}  // namespace floeplan::http
