// SPDX-License-Identifier: Apache-2.0
#include "app/capture/camera/system_camera.hpp"

#include "app/capture/camera/camera_format.hpp"
#include "app/capture/camera/frame_pixels.hpp"

#include <QCameraFormat>
#include <QList>
#include <QString>

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tp {

namespace {

constexpr std::chrono::milliseconds patience{
    4000};                               ///< without a frame: cameras take up to two seconds to begin
constexpr double shortest_wait_s = 0.06; ///< between two frames: more than one aims with cost time only

/// Frames as they come.
class SystemFrames final : public FrameSource {
public:
    SystemFrames(std::shared_ptr<NewestFrame> frames, std::string name, HeldCamera held)
        : frames_(std::move(frames)), name_(std::move(name)), held_(held) {}

    Result<std::optional<CameraFrame>> next() override {
        for (;;) {
            NewestFrame::Taken taken;
            switch (frames_->take(taken, patience)) {
            case NewestFrame::Came::frame:
                break;
            case NewestFrame::Came::end:
                return std::optional<CameraFrame>();
            case NewestFrame::Came::nothing:
                frames_->fail(why_silent(name_, last_s_.has_value()));
                [[fallthrough]];
            case NewestFrame::Came::trouble:
                return Error{sentence_of(frames_->trouble())};
            }
            if (last_s_ && taken.time_s - *last_s_ < shortest_wait_s)
                continue;
            CameraFrame frame;
            frame.pixels = upright_pixels(std::move(taken.frame));
            if (frame.pixels.empty()) {
                frames_->fail(CameraTrouble::unreadable);
                return Error{sentence_of(CameraTrouble::unreadable)};
            }
            last_s_ = frame.time_s = taken.time_s;
            return std::optional(std::move(frame));
        }
    }
    HeldCamera held() const override { return held_; }
    void interrupt() override { frames_->end(); }

private:
    std::shared_ptr<NewestFrame> frames_;
    std::string name_;
    HeldCamera held_;
    std::optional<double> last_s_; ///< of the last frame that was given
};

/// A camera of which nothing is known looks at whoever sits before it.
bool is_front(const QCameraDevice& camera) { return camera.position() != QCameraDevice::BackFace; }

QCameraDevice chosen(CameraSide side) {
    const QList<QCameraDevice> all = QMediaDevices::videoInputs();
    for (const QCameraDevice& camera : all)
        if (is_front(camera) == (side == CameraSide::front))
            return camera;
    return all.isEmpty() ? QCameraDevice() : QMediaDevices::defaultVideoInput();
}

std::optional<QCameraFormat> best_format(const QCameraDevice& camera) {
    const QList<QCameraFormat> formats = camera.videoFormats();
    std::vector<CameraForm> forms;
    for (const QCameraFormat& format : formats)
        forms.push_back({format.resolution(), format.pixelFormat(), format.maxFrameRate()});
    const auto best = best_form(forms);
    return best ? std::optional(formats[static_cast<qsizetype>(*best)]) : std::nullopt;
}

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

struct SystemCamera::Running {
    explicit Running(const QCameraDevice& device) : camera(device) {
        session.setCamera(&camera);
        session.setVideoSink(&sink);
    }
    std::shared_ptr<NewestFrame> frames = std::make_shared<NewestFrame>();
    QVideoSink sink;
    QCamera camera;
    QMediaCaptureSession session;
};

SystemCamera::SystemCamera() = default;

SystemCamera::~SystemCamera() { close(); }

Result<std::unique_ptr<FrameSource>> SystemCamera::open(CameraSide side) {
    close();
    if (!devices_) {
        devices_ = std::make_unique<QMediaDevices>();
        connect(devices_.get(), &QMediaDevices::videoInputsChanged, this, &SystemCamera::look_for_it);
    }
    const QCameraDevice device = chosen(side);
    if (device.isNull())
        return Error{sentence_of(why_none())};
    running_ = std::make_unique<Running>(device);
    if (const auto format = best_format(device))
        running_->camera.setCameraFormat(*format);
    const std::shared_ptr<NewestFrame> frames = running_->frames;
    const std::string name = device.description().toStdString();
    connect(
        &running_->sink, &QVideoSink::videoFrameChanged, this,
        [frames](const QVideoFrame& frame) {
            if (frame.isValid())
                frames->put(frame, now_s());
        },
        Qt::DirectConnection);
    connect(&running_->camera, &QCamera::errorOccurred, this,
            [frames, name](QCamera::Error error, const QString&) {
                if (error != QCamera::NoError)
                    frames->fail(why_silent(name, false));
            });
    running_->camera.start();
    return std::unique_ptr<FrameSource>(
        std::make_unique<SystemFrames>(frames, name, HeldCamera{is_front(device), false}));
}

void SystemCamera::close() {
    if (!running_)
        return;
    running_->frames->end();
    running_->camera.stop();
    running_.reset();
}

/// A camera that is pulled out stops without a word.
void SystemCamera::look_for_it() {
    if (running_ && !QMediaDevices::videoInputs().contains(running_->camera.cameraDevice()))
        running_->frames->fail(CameraTrouble::unplugged);
}

std::string SystemCamera::name() const {
    return running_ ? running_->camera.cameraDevice().description().toStdString() : std::string();
}

bool SystemCamera::has_both() const {
    bool front = false, back = false;
    for (const QCameraDevice& camera : QMediaDevices::videoInputs())
        (is_front(camera) ? front : back) = true;
    return front && back;
}

bool SystemCamera::has_torch() const {
    return running_ && running_->camera.isTorchModeSupported(QCamera::TorchOn);
}

void SystemCamera::light(bool on) {
    if (has_torch())
        running_->camera.setTorchMode(on ? QCamera::TorchOn : QCamera::TorchOff);
}

} // namespace tp
