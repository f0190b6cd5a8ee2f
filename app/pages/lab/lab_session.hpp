// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/pages/lab/lab_field.hpp"
#include "app/pages/lab/lab_files.hpp"
#include "app/pages/lab/lab_playback.hpp"
#include "app/pages/lab/lab_replay.hpp"
#include "app/pages/lab/lab_servo.hpp"
#include "app/pages/lab/lab_setup.hpp"
#include "app/pages/lab/lab_trace.hpp"
#include "app/parts/narration/narrator.hpp"
#include "app/parts/preferences/preferences.hpp"
#include "app/parts/work/newest_work.hpp"
#include "device/registry.hpp"

#include <QImage>
#include <QObject>
#include <QPointF>
#include <QQmlPropertyMap>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <QUrl>
#include <QtQml/qqmlregistration.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace tp {

class FaceExtractor;

struct LabSettings {
    SurfaceSize surface{220.0, 160.0, 8.0, {}};
    std::filesystem::path folder; ///< of recordings and tables; made when it is needed
    std::function<std::vector<ListedDevice>()> find_devices = list_devices; ///< called on a thread of its own
    VirtualClock* time = nullptr; ///< for tests: nothing happens but by advance()
};

/// The lab: a scene under a device, the law and its parameters, what the servo does, and its files.
///
/// Places are millimetres from the surface's top left corner, y down, as they are drawn; forces in newtons likewise.
class LabSession final : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Made by the program.")

    Q_PROPERTY(State state READ state NOTIFY changed)
    Q_PROPERTY(bool recording READ recording NOTIFY changed)
    /// What goes on, in a sentence.
    Q_PROPERTY(QString status READ status NOTIFY changed)
    // Each of these is an index into the options of its name.
    Q_PROPERTY(int scene READ scene NOTIFY changed)
    Q_PROPERTY(QStringList scenes READ scenes NOTIFY changed)
    Q_PROPERTY(int law READ law NOTIFY changed)
    Q_PROPERTY(QStringList laws READ laws NOTIFY changed)
    Q_PROPERTY(int device READ device NOTIFY changed)
    Q_PROPERTY(QStringList devices READ devices NOTIFY changed)
    /// Every number and switch of LabParameters by its key.
    Q_PROPERTY(QQmlPropertyMap* values READ values CONSTANT)
    /// What undo() takes back, in words; empty: nothing.
    Q_PROPERTY(QString undoable READ undoable NOTIFY changed)

    Q_PROPERTY(double surfaceWidth READ surfaceWidth CONSTANT)
    Q_PROPERTY(double surfaceHeight READ surfaceHeight CONSTANT)
    Q_PROPERTY(QPointF finger READ finger NOTIFY moved)
    Q_PROPERTY(QPointF pointer READ pointer NOTIFY moved)
    Q_PROPERTY(QPointF force READ force NOTIFY moved)
    Q_PROPERTY(double newtons READ newtons NOTIFY moved)

    /// The force field over the surface with its legend below, at the scale of setFieldScale.
    Q_PROPERTY(QImage field READ field NOTIFY fieldChanged)
    Q_PROPERTY(int legendPixels READ legendPixels CONSTANT)
    Q_PROPERTY(QString fieldWords READ fieldWords NOTIFY changed)
    /// What each plot shows, as sentences, in the order of Quantity; twice a second.
    Q_PROPERTY(QStringList readings READ readings NOTIFY readingsChanged)
    Q_PROPERTY(QString folder READ folder CONSTANT)
    /// Names of the recordings in the folder, the newest first.
    Q_PROPERTY(QStringList recordings READ recordings NOTIFY recordingsChanged)
public:
    enum State {
        Stopped,
        Opening, ///< a real device is being opened
        Running,
        Replaying,
    };
    Q_ENUM(State)
    enum Quantity { Position, Force, Energy, Lateness };
    Q_ENUM(Quantity)

    /// Both must outlive the session. The person's own strongest force holds for every real device.
    LabSession(Narrator& narrator, Preferences& preferences, LabSettings settings);
    ~LabSession() override;

    State state() const { return state_; }
    bool recording() const { return recording_; }
    QString status() const { return status_; }
    int scene() const { return scene_; }
    QStringList scenes() const;
    int law() const { return static_cast<int>(parameters_.law); }
    QStringList laws() const;
    int device() const { return device_; }
    QStringList devices() const;
    QQmlPropertyMap* values() { return &values_; }
    QString undoable() const { return history_.empty() ? QString() : history_.back().what; }
    double surfaceWidth() const { return settings_.surface.width_mm; }
    double surfaceHeight() const { return settings_.surface.height_mm; }
    QPointF finger() const { return to_sheet(finger_); }
    QPointF pointer() const { return to_sheet(pointer_); }
    QPointF force() const { return {force_.x, -force_.y}; }
    double newtons() const { return length(force_); }
    QImage field() const { return field_.image(); }
    int legendPixels() const { return LabField::legend_pixels; }
    QString fieldWords() const;
    QStringList readings() const { return readings_; }
    QString folder() const { return files_.folder_words(); }
    QStringList recordings() const { return files_.recordings(); }

    const LabParameters& parameters() const { return parameters_; }
    const LabTrace& trace() const { return trace_; }
    const FlatScene& flat() const { return flat_; }

    Q_INVOKABLE void enter();
    Q_INVOKABLE void leave();
    /// Escape: stops what runs; false where nothing does.
    Q_INVOKABLE bool stop();

    Q_INVOKABLE void chooseScene(int index);
    Q_INVOKABLE void openPhoto(const QUrl& file);
    Q_INVOKABLE void chooseLaw(int index);
    /// `label` is what the page calls it, for the ear.
    Q_INVOKABLE void setNumber(const QString& key, double value, const QString& label);
    Q_INVOKABLE void setSwitch(const QString& key, bool on, const QString& label);
    Q_INVOKABLE double lowest(const QString& key) const;
    Q_INVOKABLE double highest(const QString& key) const;
    Q_INVOKABLE double step(const QString& key) const;
    /// A value with its unit.
    Q_INVOKABLE QString words(const QString& key, double value) const;
    Q_INVOKABLE void reset();
    Q_INVOKABLE void undo();

    Q_INVOKABLE void findDevices();
    Q_INVOKABLE void chooseDevice(int index);
    Q_INVOKABLE void start();
    /// The simulated device's next write takes 200 ms.
    Q_INVOKABLE void hang();
    Q_INVOKABLE void touchDown(double x, double y);
    Q_INVOKABLE void moveTo(double x, double y);
    Q_INVOKABLE void nudge(double dx, double dy);
    Q_INVOKABLE void whereAmI();
    Q_INVOKABLE void readPlots();

    Q_INVOKABLE void toggleRecording();
    Q_INVOKABLE void replay(int index);
    Q_INVOKABLE void writeTable();
    /// Pixels a millimetre at which the field is drawn.
    Q_INVOKABLE void setFieldScale(double pixels_per_mm) { field_.set_scale(pixels_per_mm); }

    /// So much virtual time passes.
    void advance(double seconds);

signals:
    void changed();
    void moved();
    void fieldChanged();
    void readingsChanged();
    void recordingsChanged();
    /// The trace has grown or begun anew.
    void plotted();
    /// Another page is wanted; emitted by the page.
    void pageAsked(const QString& page);

private:
    struct Step {
        QString what;
        LabParameters before;
    };
    QPointF to_sheet(Vec2 p) const;
    Vec2 to_surface(QPointF p) const;
    Rect surface() const;
    void tell(const QString& sentence) { narrator_.tell(sentence, Priority::touch); }
    void say(const QString& sentence);
    void become(State state, const QString& status);
    bool fixed();
    template <typename Change>
    void make(const QString& what, const QString& said, Change change);
    void take(const LabParameters& parameters);
    void apply(LabEffect effect);
    void use_scene(int index, const QString& name, FlatScene flat);
    void use_photo(const QString& file);

    bool simulated() const { return device_ == 0; }
    LabParameters allowed() const;
    void open(const std::filesystem::path& recording);
    void run(const std::shared_ptr<DeviceChain>& chain);
    void end_run();
    QString finish_recording();
    void poll();
    void poll_run();
    void poll_replay();
    void watch(Fault fault);
    void read_out();
    std::string setup() const;

    Narrator& narrator_;
    Preferences& preferences_;
    LabSettings settings_;
    SteadyClock steady_;
    Clock& clock_;

    State state_ = Stopped;
    QString status_;
    bool recording_ = false;
    int scene_ = 0;
    QString scene_name_;
    FlatScene flat_;
    std::shared_ptr<const HapticScene> felt_; ///< the same as the servo renders, for the page's own questions
    QString photo_;                           ///< file; empty: none was opened
    LabParameters parameters_;
    QQmlPropertyMap values_;
    std::vector<Step> history_;
    std::vector<ListedDevice> found_;
    int device_ = 0;

    std::unique_ptr<LabServo> servo_;
    LabTrace trace_;
    Vec2 pointer_{0.0}, finger_{0.0}, force_{0.0};
    Fault fault_ = Fault::none;
    Fault told_ = Fault::none;
    double told_at_ = -1e9; ///< s
    int polls_ = 0;
    QStringList readings_;
    std::filesystem::path recording_file_;
    bool recording_whole_ = true;

    LabFiles files_;
    std::optional<LabPlayback> playback_;
    QString replay_words_;

    LabField field_;
    QTimer timer_;
    std::shared_ptr<std::unique_ptr<FaceExtractor>> extractor_; ///< what is in it belongs to photo_work_'s thread
    NewestWork photo_work_, device_work_, replay_work_; ///< last: they end first
};

} // namespace tp
