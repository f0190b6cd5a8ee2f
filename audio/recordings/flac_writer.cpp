// SPDX-License-Identifier: Apache-2.0
#include "audio/recordings/flac_writer.hpp"

#include "core/files/file_words.hpp"
#include "core/files/open_file.hpp"

#include <cerrno>
#include <cstdio>
#include <sndfile.h>
#include <utility>

namespace tp {

namespace {

int subtype_of(SampleDepth depth) {
    switch (depth) {
    case SampleDepth::bits_8:
        return SF_FORMAT_PCM_S8;
    case SampleDepth::bits_16:
        return SF_FORMAT_PCM_16;
    case SampleDepth::bits_24:
        break;
    }
    return SF_FORMAT_PCM_24;
}

} // namespace

struct FlacWriter::Impl {
    OpenFile place;
    SNDFILE* file = nullptr;
    int error = 0; ///< the first errno; libsndfile does not tell

    Impl() = default;
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        if (file != nullptr)
            sf_close(file);
    }

    std::string reason() const { return error != 0 ? reason_of(error) : "the FLAC encoder reports a fault."; }

    static Impl& self(void* user) { return *static_cast<Impl*>(user); }
    static sf_count_t size(void* user) {
        const auto facts = self(user).place.facts();
        return facts ? static_cast<sf_count_t>(facts->bytes) : -1;
    }
    static sf_count_t go_to(sf_count_t offset, int whence, void* user) {
        return self(user).place.go_to(offset, whence);
    }
    static sf_count_t take(void* to, sf_count_t count, void* user) {
        return self(user).place.read({static_cast<char*>(to), static_cast<std::size_t>(count)});
    }
    static sf_count_t put(const void* from, sf_count_t count, void* user) {
        Impl& impl = self(user);
        if (impl.error != 0)
            return 0;
        const Written written =
            impl.place.write({static_cast<const char*>(from), static_cast<std::size_t>(count)});
        impl.error = written.error;
        return static_cast<sf_count_t>(written.count);
    }
    static sf_count_t where(void* user) { return self(user).place.go_to(0, SEEK_CUR); }
};

FlacWriter::FlacWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
FlacWriter::FlacWriter(FlacWriter&&) noexcept = default;
FlacWriter::~FlacWriter() = default;

Result<FlacWriter> FlacWriter::over(const std::filesystem::path& file, const SoundFormat& format,
                                    SampleDepth depth) {
    auto impl = std::make_unique<Impl>();
    impl->place = OpenFile(file, {.write = true, .emptied = true});
    if (!impl->place.ok())
        return Error{reason_of(errno)};
    SF_INFO info{};
    info.samplerate = format.rate;
    info.channels = format.channels;
    info.format = SF_FORMAT_FLAC | subtype_of(depth);
    SF_VIRTUAL_IO io{Impl::size, Impl::go_to, Impl::take, Impl::put, Impl::where};
    impl->file = sf_open_virtual(&io, SFM_WRITE, &info, impl.get());
    if (impl->file == nullptr)
        return Error{impl->reason()};
    return FlacWriter(std::move(impl));
}

std::string FlacWriter::write(std::span<const std::int32_t> samples) {
    const auto count = static_cast<sf_count_t>(samples.size());
    const bool done = sf_write_int(impl_->file, samples.data(), count) == count && impl_->error == 0;
    return done ? std::string{} : impl_->reason();
}

std::string FlacWriter::finish() {
    const int closed = sf_close(std::exchange(impl_->file, nullptr));
    return closed == 0 && impl_->error == 0 ? std::string{} : impl_->reason();
}

} // namespace tp
