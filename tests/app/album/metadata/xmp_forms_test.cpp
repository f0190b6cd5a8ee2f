// SPDX-License-Identifier: Apache-2.0
// Every form that RDF has for a value, as it is read, and how each is written, to the letter.
#include "app/album/metadata/xmp_names.hpp"
#include "app/album/metadata/xmp_packet.hpp"
#include "test_program.hpp"

#include <QTest>

#include <string>
#include <vector>

namespace xmp_forms_test {

using namespace tp;

namespace {

const std::string foreign = "http://example.org/foreign/";
const std::string start = "<rdf:RDF xmlns:rdf=\"" + xmp::rdf_uri + "\" xmlns:f=\"" + foreign +
                          "\"><rdf:Description rdf:about=\"\">";
const std::string end = "</rdf:Description></rdf:RDF>";

/// A value in one line: its form's first letter, its text, its parts, and behind "?" what is said of it.
std::string told(const XmpValue& value) {
    std::string text(1, "tlsbqa"[static_cast<std::size_t>(value.form)]);
    text += "'" + value.text + "'";
    for (const XmpField& field : value.fields)
        text += "{" + field.name.name + " " + told(field.value) + "}";
    for (const XmpValue& item : value.items)
        text += "[" + told(item) + "]";
    for (const XmpField& qualifier : value.qualifiers)
        text += "?" + qualifier.name.name + " " + told(qualifier.value);
    return text;
}

/// What the property f:p is, that is written so.
QString read(const std::string& property) {
    const auto packet = XmpPacket::from(start + property + end);
    const auto value = packet ? packet->value({foreign, "p"}) : std::nullopt;
    return value ? QString::fromStdString(told(*value)) : QStringLiteral("nothing");
}

/// How it is written into an empty packet.
QString written(const XmpValue& value, const XmpName& name = {foreign, "p"},
                const std::string& into = start + end) {
    auto packet = XmpPacket::from(into);
    packet->set(name, value);
    const std::string bytes = packet->bytes();
    const std::size_t from = bytes.find("\n   ") + 4;
    return QString::fromStdString(bytes.substr(from, bytes.rfind("</rdf:Description>") - from));
}

XmpValue of_form(XmpValue::Form form, const std::vector<XmpValue>& items) {
    XmpValue value;
    value.form = form;
    value.items = items;
    return value;
}

} // namespace

class XmpFormsTest : public QObject {
    Q_OBJECT
private slots:
    void texts_are_read() {
        QCOMPARE(read("<f:p>a</f:p>"), QString("t'a'"));
        QCOMPARE(read("<f:p/>"), QString("t''"));
        QCOMPARE(read("<f:p>a<!-- c -->b<![CDATA[&lt;]]>&amp;<?x y?></f:p>"), QString("t'ab&lt;&'"));
        QCOMPARE(read("<f:p> a\n</f:p>"), QString("t' a\n'"));
        QCOMPARE(read("<f:p xml:lang='de'>a</f:p>"), QString("t'a'?lang t'de'"));
        QCOMPARE(read("<f:p xml:lang='a&amp;b'/>"), QString("t''?lang t'a&b'"));
        QCOMPARE(read("<f:p rdf:datatype='x' rdf:ID='y' plain='z' xmlns:g='urn:g'>a</f:p>"), QString("t'a'"));
        QCOMPARE(read("<g:p xmlns:g='" + foreign + "'>a</g:p>"), QString("t'a'"));
    }

    void links_structures_and_lists_are_read() {
        QCOMPARE(read("<f:p rdf:resource='a&amp;b'/>"), QString("l'a&b'"));
        QCOMPARE(read("<f:p rdf:resource='a' f:q='b'/>"), QString("l'a'?q t'b'"));
        QCOMPARE(read("<f:p f:a='1' f:b='2'/>"), QString("s''{a t'1'}{b t'2'}"));
        QCOMPARE(read("<f:p rdf:parseType='Resource'><f:a>1</f:a>text<f:b/></f:p>"),
                 QString("s''{a t'1'}{b t''}"));
        QCOMPARE(read("<f:p rdf:parseType='Resource'/>"), QString("s''"));
        QCOMPARE(read("<f:p rdf:parseType='Literal'>a</f:p>"), QString("t'a'"));
        QCOMPARE(read("<f:p f:parseType='Resource'>a</f:p>"), QString("s''{parseType t'Resource'}"));
        QCOMPARE(read("<f:p><rdf:Description f:a='1'><f:b>2</f:b></rdf:Description></f:p>"),
                 QString("s''{a t'1'}{b t'2'}"));
        QCOMPARE(read("<f:p> <!-- c --><rdf:Bag><rdf:li>1</rdf:li> <!-- c --><rdf:li/></rdf:Bag></f:p>"),
                 QString("b''[t'1'][t'']"));
        QCOMPARE(read("<f:p><rdf:Seq><rdf:li>1</rdf:li></rdf:Seq></f:p>"), QString("q''[t'1']"));
        QCOMPARE(read("<f:p><rdf:Alt><rdf:li xml:lang='de'>1</rdf:li></rdf:Alt></f:p>"),
                 QString("a''[t'1'?lang t'de']"));
        QCOMPARE(read("<f:p><f:Bag><f:li>1</f:li></f:Bag></f:p>"), QString("s''{li t'1'}"));
        QCOMPARE(read("<f:p><g:Seq xmlns:g='" + xmp::rdf_uri + "'><g:li f:a='1'/></g:Seq></f:p>"),
                 QString("q''[s''{a t'1'}]"));
        QCOMPARE(read("<f:p xmlns:g='" + foreign + "g'><rdf:Bag><rdf:li g:a='1'/></rdf:Bag></f:p>"),
                 QString("b''[s''{a t'1'}]"));
        QCOMPARE(read("<f:p rdf:parseType='Resource'><unknown:a>1</unknown:a><f:b>2</f:b></f:p>"),
                 QString("s''{b t'2'}"));
    }

    void what_is_said_of_a_value_is_read() {
        QCOMPARE(read("<f:p rdf:parseType='Resource'><rdf:value>1</rdf:value><f:q>2</f:q><f:r>3</f:r></f:p>"),
                 QString("t'1'?q t'2'?r t'3'"));
        QCOMPARE(
            read("<f:p rdf:parseType='Resource'><f:q>2</f:q><rdf:value><rdf:Bag><rdf:li>1</rdf:li></rdf:Bag>"
                 "</rdf:value></f:p>"),
            QString("b''[t'1']?q t'2'"));
        QCOMPARE(read("<f:p rdf:value='1' f:q='2'/>"), QString("t'1'?q t'2'"));
        QCOMPARE(read("<f:p><rdf:Description rdf:value='1' f:q='2'/></f:p>"), QString("t'1'?q t'2'"));
        QCOMPARE(
            read("<f:p xml:lang='de' rdf:parseType='Resource'><rdf:value>1</rdf:value><f:q>2</f:q></f:p>"),
            QString("t'1'?q t'2'?lang t'de'"));
    }

    void each_form_is_written() {
        XmpValue link = XmpValue::of("a&b");
        link.form = XmpValue::Form::link;
        XmpValue structure;
        structure.form = XmpValue::Form::structure;
        structure.fields = {{{foreign, "a"}, XmpValue::of("1")}, {{foreign, "b"}, link}};
        QCOMPARE(written(XmpValue::of("<1>")), QString("<f:p>&lt;1&gt;</f:p>"));
        QCOMPARE(written(XmpValue::of("")), QString("<f:p/>"));
        QCOMPARE(written(link), QString("<f:p rdf:resource=\"a&amp;b\"/>"));
        QCOMPARE(
            written(structure),
            QString("<f:p rdf:parseType=\"Resource\"><f:a>1</f:a><f:b rdf:resource=\"a&amp;b\"/></f:p>"));
        QCOMPARE(written(of_form(XmpValue::Form::bag, {XmpValue::of("1"), XmpValue::of("2")})),
                 QString("<f:p><rdf:Bag><rdf:li>1</rdf:li><rdf:li>2</rdf:li></rdf:Bag></f:p>"));
        QCOMPARE(
            written(of_form(XmpValue::Form::seq, {structure})),
            QString(
                "<f:p><rdf:Seq><rdf:li rdf:parseType=\"Resource\"><f:a>1</f:a><f:b rdf:resource=\"a&amp;b\"/>"
                "</rdf:li></rdf:Seq></f:p>"));
        XmpValue german = XmpValue::of("1");
        german.qualifiers = {{xmp::language, XmpValue::of("de")}};
        QCOMPARE(written(of_form(XmpValue::Form::alt, {german})),
                 QString("<f:p><rdf:Alt><rdf:li xml:lang=\"de\">1</rdf:li></rdf:Alt></f:p>"));
        german.qualifiers.push_back({{foreign, "q"}, XmpValue::of("2")});
        QCOMPARE(written(german),
                 QString("<f:p xml:lang=\"de\" rdf:parseType=\"Resource\"><rdf:value>1</rdf:value>"
                         "<f:q>2</f:q></f:p>"));
        structure.fields = {{{xmp::xml_uri, "space"}, XmpValue::of("x")}};
        QCOMPARE(written(structure),
                 QString("<f:p rdf:parseType=\"Resource\"><xml:space>x</xml:space></f:p>"));
    }

    /// The one that the file uses, else the usual one, with a number where that means something else there.
    void a_prefix_is_found_for_each_namespace() {
        XmpValue structure;
        structure.form = XmpValue::Form::structure;
        structure.fields = {{{xmp::dc_uri, "a"}, XmpValue::of("1")},
                            {{"urn:one", "b"}, XmpValue::of("2")},
                            {{"urn:two&", "c"}, XmpValue::of("3")},
                            {{"urn:one", "d"}, XmpValue::of("4")}};
        QCOMPARE(written(structure), "<f:p rdf:parseType=\"Resource\" xmlns:dc=\"" +
                                         QString::fromStdString(xmp::dc_uri) +
                                         "\" xmlns:ns=\"urn:one\" xmlns:ns2=\"urn:two&amp;\"><dc:a>1</dc:a>"
                                         "<ns:b>2</ns:b><ns2:c>3</ns2:c><ns:d>4</ns:d></f:p>");
        const std::string taken = "<rdf:RDF xmlns:rdf=\"" + xmp::rdf_uri +
                                  "\" xmlns:dc=\"urn:x\" xmlns:dc2=\"urn:y\"><rdf:Description>" + end;
        QCOMPARE(written(XmpValue::of("1"), {xmp::dc_uri, "a"}, taken),
                 "<dc3:a xmlns:dc3=\"" + QString::fromStdString(xmp::dc_uri) + "\">1</dc3:a>");
        const std::string hidden = "<x xmlns:dc=\"" + xmp::dc_uri + "\" xmlns:d=\"" + xmp::dc_uri +
                                   "\"><rdf:RDF xmlns:rdf=\"" + xmp::rdf_uri +
                                   "\" xmlns:d=\"urn:x\"><rdf:Description>" + end + "</x>";
        QCOMPARE(written(XmpValue::of("1"), {xmp::dc_uri, "a"}, hidden), QString("<dc:a>1</dc:a>"));
        const std::string plain =
            "<rdf:RDF xmlns:rdf=\"" + xmp::rdf_uri + "\" xmlns=\"" + foreign + "\"><rdf:Description>" + end;
        QCOMPARE(written(XmpValue::of("1"), {foreign, "a"}, plain),
                 "<ns:a xmlns:ns=\"" + QString::fromStdString(foreign) + "\">1</ns:a>");
    }

    /// A letter of ASCII, "_" or any other letter begins a name (XML 1.0, 2.3), and no digit.
    void which_prefixes_are_used_again() {
        for (const auto& [prefix, used] : std::vector<std::pair<std::string, bool>>{{"a", true},
                                                                                    {"z", true},
                                                                                    {"A", true},
                                                                                    {"Z", true},
                                                                                    {"_", true},
                                                                                    {"\xC3\xA9", true},
                                                                                    {"f-1", true},
                                                                                    {"1f", false},
                                                                                    {"-f", false},
                                                                                    {".f", false}}) {
            const std::string into = "<rdf:RDF xmlns:rdf=\"" + xmp::rdf_uri + "\" xmlns:" + prefix +
                                     "=\"urn:x\">" + "<rdf:Description>" + end;
            const QString wanted = QString::fromStdString(used ? prefix : std::string("ns"));
            QVERIFY2(written(XmpValue::of("1"), {"urn:x", "a"}, into).startsWith('<' + wanted + ":a"),
                     prefix.c_str());
        }
    }
};

} // namespace xmp_forms_test

TP_TEST(xmp_forms_test, XmpFormsTest, event_loop)
#include "xmp_forms_test.moc"
